package org.toqa.traffic.floor;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Instant;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.Margins;
import org.toqa.grid.Moves;
import org.toqa.grid.OccupancyGrid;

/** A robot makes room, whatever is configured to be kept from walls. */
class StepAsideTest {

  @ParameterizedTest
  @ValueSource(doubles = {0, 0.01, 0.05, 1})
  void leavesWhatAnotherNeeds(double margin) {
    OccupancyGrid hall = DrivenFloor.draw(".....", ".....", ".....");
    FreeSpace space = new FreeSpace(hall, new Margins(margin, Margins.USUAL.formation()));
    Vec2 at = hall.centre(new Cell(2, 1));
    double radius = DrivenFloor.DIAMETER / 2;
    TrafficRobot robot =
        new TrafficRobot("r", 1, hall, new Pose(at.x(), at.y(), 0), radius, Instant.EPOCH);

    assertTrue(
        new SingleRobotPlanner(space, new SectionFitter(), Moves.HEADING)
            .pathOutOf(robot, List.of(), List.of(SweptArea.at(at, radius)))
            .isPresent());
  }
}
