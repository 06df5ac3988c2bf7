package org.toqa.traffic.floor;

import java.util.ArrayList;
import java.util.List;
import org.toqa.geometry.Pose;
import org.toqa.motion.Segment;

/** What is a robot's own: where it is, and what it may drive and has not driven yet. */
final class Allocation {
  private Allocation() {}

  /** In parts: where the robot is, and all of what it may drive. */
  static List<SweptArea> areas(TrafficRobot robot) {
    List<SweptArea> areas = new ArrayList<>(robot.drive.allocatedBehindOpen());
    robot.drive.openSection().ifPresent(open -> areas.addAll(areasAhead(robot, open)));
    areas.addAll(robot.drive.roomAreas());
    if (areas.stream().noneMatch(robot::isWithin)) {
      areas.add(placeArea(robot));
    }
    return areas;
  }

  /** What it has still to cover of the section that it is on: what is behind it is nobody's. */
  private static List<SweptArea> areasAhead(TrafficRobot robot, Drive.OpenSection open) {
    Segment first = open.segments().getFirst();
    boolean isBesidePath = robot.isFormation() || robot.drive.lentRoom() != null;
    double done = isBesidePath ? 0 : first.shareDone(open.start(), robot.pose());
    Pose at = open.start().advanced(first.twist(), done * first.t());
    List<SweptArea> areas = new ArrayList<>();
    areas.add(done == 1 ? robot.areaAt(at) : robot.sweptArea(at, first.after(done)));
    at = open.start().advanced(first.twist(), first.t());
    for (Segment segment : open.segments().subList(1, open.segments().size())) {
      areas.add(robot.sweptArea(at, segment));
      at = at.advanced(segment.twist(), segment.t());
    }
    return areas;
  }

  /** What it covers at the place that it was sent to, if it is there; else where it is. */
  private static SweptArea placeArea(TrafficRobot robot) {
    Pose place = robot.drive.lastPathEnd();
    if (place == null) {
      return robot.standingArea();
    }
    SweptArea area = robot.areaAt(place);
    boolean isThere =
        robot.isFormation()
            ? FormationPlanner.isAtPlace(place, robot.pose())
            : robot.isWithin(area);
    return isThere ? area : robot.standingArea();
  }

  /** Seconds at the planned speed until the robot has driven all that it may. */
  static double secondsAhead(TrafficRobot robot) {
    double seconds = robot.drive.secondsBehindOpen();
    Drive.OpenSection open = robot.drive.openSection().orElse(null);
    if (open == null) {
      return seconds;
    }
    double done = open.segments().getFirst().shareDone(open.start(), robot.pose());
    for (Segment segment : open.segments()) {
      seconds += segment.t();
    }
    return seconds - done * open.segments().getFirst().t();
  }
}
