/** Where a robot is on its map: what it knows by its wheels, corrected by what it measures. */
@NullMarked
package org.toqa.localisation;

import org.jspecify.annotations.NullMarked;
