/** The floor agents: each the single writer of its floor, its missions, traffic and charging. */
@NullMarked
package org.toqa.fleet.floor;

import org.jspecify.annotations.NullMarked;
