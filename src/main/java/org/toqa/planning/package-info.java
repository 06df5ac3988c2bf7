/** Finds a path for one robot on a grid; says by name why there is none. */
@NullMarked
package org.toqa.planning;

import org.jspecify.annotations.NullMarked;
