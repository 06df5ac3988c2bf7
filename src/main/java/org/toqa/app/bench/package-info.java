/** {@code toqa bench}: how good and how fast the planners are, as JSON. */
@NullMarked
package org.toqa.app.bench;

import org.jspecify.annotations.NullMarked;
