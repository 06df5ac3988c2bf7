package org.toqa.traffic.floor;

import org.toqa.geometry.Vec2;

/**
 * A disc somewhere on a floor.
 *
 * @param centre metres, map frame
 * @param radius metres
 */
record PlacedDisc(Vec2 centre, double radius) {}
