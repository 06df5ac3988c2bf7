package org.toqa.traffic.floor;

import java.util.List;
import org.toqa.motion.PassingRoom;

/**
 * Room beside a robot's path that is lent to it.
 *
 * @param areas what the robot can cover beside each of the segments, in their order; or in a free
 *     zone, all of that
 */
record LentRoom(PassingRoom room, List<SweptArea> areas) {
  LentRoom {
    areas = List.copyOf(areas);
  }

  /** What it can still cover when so many segments of its path are completed. */
  List<SweptArea> areasFrom(int completedSegments) {
    if (room.zone() != null) {
      return areas;
    }
    int behind = Math.clamp(completedSegments - room.from(), 0, areas.size());
    return areas.subList(behind, areas.size());
  }
}
