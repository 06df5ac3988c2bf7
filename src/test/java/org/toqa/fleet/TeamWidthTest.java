package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.geometry.Vec2;
import org.toqa.mission.TaskState;
import org.toqa.motion.DriveKind;
import org.toqa.wording.Phrase;

/** A team with a wide robot has no room for a load, and one of two narrow robots has. */
class TeamWidthTest extends HallFleetTest {
  private static final double WIDE = 1.2;

  @ParameterizedTest
  @EnumSource(DriveKind.class)
  void aLoadWaitsForTheNarrowerTeam(DriveKind kind) throws Exception {
    stage.add("r2", EAST, "P2");
    stage.add("wide", new Vec2(10.5, 1.5), null).setFootprint(WIDE);
    List.of("r1", "r2", "wide").forEach(name -> scriptedRobot(name).setKind(kind));
    stage.restart();
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
    accepted(stage.fleet.holdRobot("r1", "Max"));
    until(view -> robot(view, "r1").state() == RobotState.HOLDING);

    TaskOrder order =
        new TaskOrder(
            "plate",
            8,
            new Where.Point(new Vec2(5.5, 1.5)), // beside the door
            new Where.Point(new Vec2(12.5, 1.5)),
            null,
            0,
            null,
            null);
    assertEquals(
        Phrase.NEEDS_TEAM, accepted(stage.fleet.preview(order, "Clara")).reason().phrase());
    long task = submit(order);
    until(
        view -> {
          var why = task(view, task).waitingFor();
          return why != null && why.phrase() == Phrase.WAITS_FOR_OTHER_ROBOTS;
        });
    accepted(stage.fleet.resumeRobot("r1", "Max"));

    until(view -> task(view, task).state() == TaskState.TO_OBJECT);
    assertEquals(
        List.of("r1", "r2"),
        task(stage.fleet.snapshots().latest(), task).robots().stream().sorted().toList());
  }
}
