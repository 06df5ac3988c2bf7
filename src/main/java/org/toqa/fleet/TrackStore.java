package org.toqa.fleet;

import java.time.Instant;
import java.util.List;

/**
 * Where robots were. Called by threads that may wait; it throws what a {@link FleetStore} throws.
 */
public interface TrackStore {

  /** A point that is there already stays as it is. */
  void add(List<TrackPoint> points);

  /** The robot's points since then, oldest first. */
  List<TrackPoint> track(String robot, Instant since);
}
