package org.toqa.traffic.floor;

import java.util.List;
import org.toqa.geometry.Pose;
import org.toqa.motion.Segment;

/**
 * The unit of reservation: a piece of a path that is released as a whole, and at whose end the
 * robot can be stopped.
 *
 * @param segments what is driven
 * @param end where the robot then is, map frame
 * @param cells all cells that the robot touches meanwhile, from the first moment to the last
 * @param endCells those that it touches at the end
 */
record Section(List<Segment> segments, Pose end, CellSet cells, CellSet endCells) {
  Section {
    segments = List.copyOf(segments);
  }

  /** Seconds at the planned speed. */
  double duration() {
    return segments.stream().mapToDouble(Segment::t).sum();
  }
}
