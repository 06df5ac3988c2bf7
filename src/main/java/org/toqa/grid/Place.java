package org.toqa.grid;

import org.toqa.geometry.Vec2;

/**
 * A named point of a floor: a station, a parking point or a charging point.
 *
 * @param position metres in the map frame
 */
public record Place(String name, Vec2 position) {}
