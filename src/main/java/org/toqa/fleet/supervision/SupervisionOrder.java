package org.toqa.fleet.supervision;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.toqa.geometry.Vec2;

/**
 * That a supervisor and its workers shall carry the boxes of a floor.
 *
 * @param supervisor name of the robot with cameras
 * @param workers names of the robots with arms
 * @param overlaps as of {@link Supervision}
 * @param targets where each box shall lie, by the number on it, metres, map frame
 */
public record SupervisionOrder(
    String floor,
    String supervisor,
    List<String> workers,
    boolean overlaps,
    Map<Integer, Vec2> targets) {

  /** As many workers there may be. */
  public static final int MAX_WORKERS = 20;

  /** As many boxes. */
  public static final int MAX_BOXES = 200;

  public SupervisionOrder {
    workers = List.copyOf(workers);
    targets = new TreeMap<>(targets);
  }
}
