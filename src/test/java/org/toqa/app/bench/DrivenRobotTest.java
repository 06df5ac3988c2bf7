package org.toqa.app.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Ack;
import org.toqa.link.message.AgentMessage.Done;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.Reject;
import org.toqa.link.message.AgentMessage.State;
import org.toqa.link.message.ServerMessage.AckDone;
import org.toqa.link.message.ServerMessage.Cancel;
import org.toqa.link.message.ServerMessage.Drive;
import org.toqa.link.message.ServerMessage.Release;
import org.toqa.motion.Segment;

class DrivenRobotTest {
  private static final long TICK = 20_000_000;
  private static final List<Segment> TWO_METRES =
      List.of(new Segment(0.25, 0, 4), new Segment(0.25, 0, 4));

  private final List<AgentMessage> said = new ArrayList<>();
  private final PoseError error = new PoseError(0.02, 1);
  private final DrivenRobot robot =
      new DrivenRobot("r1", new Pose(0, 0, 0), 0.255, error, said::add);
  private long nanos;

  @Test
  void standsAtTheEndOfWhatIsReleasedAndTellsTheEndUntilThatIsKnown() {
    robot.receive(drive(1, 1));
    pass(10);
    assertEquals(new Ack(1), said.getFirst());
    assertEquals(1, state().pose().x(), 0.01);
    assertEquals(Mode.DRIVING, state().mode());
    assertEquals(1, state().segment());

    robot.receive(new Release(2, 1, 2));
    pass(10);
    assertEquals(2, state().pose().x(), 0.01);
    assertEquals(Mode.IDLE, state().mode());
    assertTrue(count(Done.class) > 2, said::toString);

    robot.receive(new AckDone(1));
    said.clear();
    pass(10);
    assertEquals(0, count(Done.class));
    assertTrue(Math.abs(count(State.class) - 50) <= 1, said::toString); // five a second
  }

  @Test
  void refusesAnotherDriveUntilItsOwnHasEnded() {
    robot.receive(drive(1, 2));
    pass(2);
    robot.receive(drive(2, 2));
    assertInstanceOf(Reject.class, said.getLast());

    robot.receive(new Cancel(3, 7L));
    pass(3);
    assertEquals(Mode.IDLE, state().mode());
    assertTrue(state().pose().x() < 1, state()::toString);
    robot.receive(
        new Drive(4, 7L, 1, state().pose(), TWO_METRES, 2, true, 0)); // from where it stands
    assertEquals(new Ack(4), said.getLast());
  }

  @Test
  void itsBodyIsBesideWhatItReportsAndStandsWhereItStands() {
    robot.receive(drive(1, 2));
    List<Double> beside = new ArrayList<>();
    for (int second = 0; second < 12; second++) {
      pass(1);
      beside.add(robot.truePosition().distanceTo(state().pose().position()));
    }
    // at most the bound, and what it has driven since it reported, up to 0.2 s at 0.25 m/s
    assertTrue(beside.stream().allMatch(metres -> metres < 0.02 + 0.05), beside::toString);
    assertTrue(beside.getLast() > 0, beside::toString);

    Vec2 stands = robot.truePosition();
    pass(5);
    assertEquals(stands, robot.truePosition());
    assertEquals(2, robot.metres(), 0.02);
  }

  private static Drive drive(long number, int released) {
    return new Drive(number, 7L, 1, new Pose(0, 0, 0), TWO_METRES, released, true, 0);
  }

  private void pass(int seconds) {
    for (int tick = 0; tick < seconds * 50; tick++) {
      nanos += TICK;
      boolean _ = robot.tick(nanos);
    }
  }

  private State state() {
    return said.stream()
        .filter(State.class::isInstance)
        .map(State.class::cast)
        .reduce((first, next) -> next)
        .orElseThrow();
  }

  private long count(Class<?> kind) {
    return said.stream().filter(kind::isInstance).count();
  }
}
