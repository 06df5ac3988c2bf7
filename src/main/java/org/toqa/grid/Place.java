package org.toqa.grid;

import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;

/**
 * A named point of a floor: a station, a parking point or a charging point.
 *
 * @param position metres in the map frame
 * @param heading how a robot stands there, radians counter-clockwise from map east; null: as it
 *     comes
 * @param approach the direction in which its cell is driven into; null: any
 */
public record Place(
    String name, Vec2 position, @Nullable Double heading, @Nullable Direction approach) {

  public Place(String name, Vec2 position) {
    this(name, position, null, null);
  }
}
