/** Decides which robots carry a load, and says why. */
@NullMarked
package org.toqa.allocation;

import org.jspecify.annotations.NullMarked;
