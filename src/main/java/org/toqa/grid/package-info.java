/** Occupancy grids, their margins and distances, floors, and the map files they are read from. */
@NullMarked
package org.toqa.grid;

import org.jspecify.annotations.NullMarked;
