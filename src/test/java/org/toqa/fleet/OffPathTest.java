package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.ServerMessage.Cancel;
import org.toqa.link.message.ServerMessage.Drive;
import org.toqa.mission.TaskState;

/** A robot that stands beside its path gets another one from where it is. */
class OffPathTest extends HallFleetTest {
  @Test
  void robotThatStandsBesideItsPathGoesOnFromWhereItIs() throws Exception {
    long task = submit("West", "East");
    untilCarryingOnTheWay(task);
    ScriptedRobot robot = scriptedRobot("r1");
    int before = robot.obeyed().size();

    robot.shove(new Vec2(0, -0.2));
    Vec2 aside = robot.position();
    until(view -> String.valueOf(task(view, task).waitingFor()).contains("off its path"));
    until(view -> task(view, task).state() == TaskState.DONE);

    List<?> after = robot.obeyed().subList(before, robot.obeyed().size());
    assertTrue(after.stream().anyMatch(Cancel.class::isInstance), after.toString());
    Drive next =
        after.stream()
            .filter(Drive.class::isInstance)
            .map(Drive.class::cast)
            .findFirst()
            .orElseThrow();
    assertEquals(aside, next.start().position());
    assertEquals(task, next.task());
  }
}
