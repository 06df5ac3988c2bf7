package org.toqa.traffic.floor;

import org.toqa.geometry.Vec2;

/**
 * A disc somewhere on a floor.
 *
 * @param middle metres, map frame
 * @param radius metres
 */
record Round(Vec2 middle, double radius) {}
