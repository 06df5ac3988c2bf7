/** The command {@code toqa gateway} and its configuration. */
@NullMarked
package org.toqa.app.gateway;

import org.jspecify.annotations.NullMarked;
