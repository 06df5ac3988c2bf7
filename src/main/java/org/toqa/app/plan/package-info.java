/** {@code toqa plan}: one path on a map, as a table, as JSON or as a picture. */
@NullMarked
package org.toqa.app.plan;

import org.jspecify.annotations.NullMarked;
