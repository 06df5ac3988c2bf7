package org.toqa.fleet;

import java.util.List;
import org.toqa.geometry.Vec2;
import org.toqa.wording.Sentence;

/**
 * What would become of a task if it were the next one that is given out.
 *
 * @param robots how many carry the load; 0 where no robots are there that could
 * @param chosen the robots that would carry it now; empty where it would wait
 * @param reason why these, or what it would wait for
 * @param path of the load, or of a drive its robot's, by the map, metres, map frame: the traffic
 *     may choose another one. Empty where the map alone shows none
 */
public record TaskPreview(int robots, List<String> chosen, Sentence reason, List<Vec2> path) {

  public TaskPreview {
    chosen = List.copyOf(chosen);
    path = List.copyOf(path);
  }

  /** How long the path is, metres; 0 where the path is not known. */
  public double metres() {
    return Vec2.lengthOf(path);
  }
}
