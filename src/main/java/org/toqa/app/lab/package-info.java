/** {@code toqa lab}: the experiments of the laboratory. */
@NullMarked
package org.toqa.app.lab;

import org.jspecify.annotations.NullMarked;
