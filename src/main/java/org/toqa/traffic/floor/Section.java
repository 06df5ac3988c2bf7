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
 * @param endsHalfway whether it ends between two cells: whoever has begun it goes on to the next
 *     cell before it goes elsewhere
 */
record Section(
    List<Segment> segments,
    Pose end,
    SweptArea area,
    SweptArea endArea,
    CellSet cells,
    boolean endsHalfway) {
  Section {
    segments = List.copyOf(segments);
  }

  /** The same as the last one of a path: there is no next cell. */
  Section asLast() {
    return endsHalfway ? new Section(segments, end, area, endArea, cells, false) : this;
  }

  /** Seconds at the planned speed. */
  double duration() {
    double seconds = 0;
    for (Segment segment : segments) {
      seconds += segment.t();
    }
    return seconds;
  }
}
