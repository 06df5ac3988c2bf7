package org.toqa.fleet.history;

import java.time.Instant;
import java.util.List;

/**
 * Where robots were, and how full their batteries. Called by threads that may wait; it throws what
 * a {@link org.toqa.fleet.FleetStore} throws.
 */
public interface TrackStore {

  /** A point that is there already stays as it is. */
  void add(List<TrackPoint> points);

  /** The robot's points since then, oldest first. */
  List<TrackPoint> track(String robot, Instant since);

  /**
   * The points of all these robots in a period, which ends earlier where they are too many.
   *
   * @param robots names
   * @param until the first moment after it
   * @param most how many points of the period are wanted at most; more than there are robots
   */
  FloorTracks tracksOf(List<String> robots, Instant from, Instant until, int most);

  /** A level that is there already stays as it is. */
  void addBatteryLevels(List<BatteryLevel> levels);

  /** The robot's levels since then, oldest first, and before them the last one from before. */
  List<BatteryLevel> batteryLevels(String robot, Instant since);

  /** The names of all robots that are on the floor, or were when they were removed. */
  List<String> robotsOf(String floor);
}
