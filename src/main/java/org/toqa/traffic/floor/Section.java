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
 * @param area all that the robot covers meanwhile, from the first moment to the last
 * @param endArea what it covers at the end
 * @param cells those that it touches meanwhile
 */
record Section(List<Segment> segments, Pose end, SweptArea area, SweptArea endArea, CellSet cells) {
  Section {
    segments = List.copyOf(segments);
  }

  /** Seconds at the planned speed. */
  double duration() {
    return segments.stream().mapToDouble(Segment::t).sum();
  }
}
