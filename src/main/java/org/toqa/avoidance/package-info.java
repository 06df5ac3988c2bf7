/** Steering round what range sensors see: where they look, what is on the path, where to go. */
@NullMarked
package org.toqa.avoidance;

import org.jspecify.annotations.NullMarked;
