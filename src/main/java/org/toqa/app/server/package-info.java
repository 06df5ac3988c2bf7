/** The running server: fleet, store and web tied together, and what goes on beside them. */
@NullMarked
package org.toqa.app.server;

import org.jspecify.annotations.NullMarked;
