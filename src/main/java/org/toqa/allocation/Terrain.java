package org.toqa.allocation;

import java.util.List;
import org.toqa.geometry.Vec2;

/**
 * What the map tells whoever weighs a task.
 *
 * @param chargers the floor's charging points, metres, map frame; without any, nobody looks whether
 *     a battery lasts
 */
public record Terrain(PathLengths pathLengths, List<Vec2> chargers) {
  public Terrain {
    chargers = List.copyOf(chargers);
  }
}
