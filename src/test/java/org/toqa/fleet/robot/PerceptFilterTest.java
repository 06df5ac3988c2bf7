package org.toqa.fleet.robot;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Instant;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.Role;
import org.toqa.link.message.AgentMessage.Speed;
import org.toqa.link.message.AgentMessage.State;
import org.toqa.motion.DriveKind;

class PerceptFilterTest {
  private static final Instant START = Instant.parse("2026-11-21T08:00:00Z");

  /** 0.8 m that its sensors see + 0.255 m across + 0.5 m. */
  private static final double REACH = 1.555;

  private final PerceptFilter filter = new PerceptFilter();

  @Test
  void whatIsFartherThanTheSensorsSeeIsNotBelieved() {
    Vec2 near = new Vec2(5 + REACH - 0.01, 5);
    Vec2 far = new Vec2(5 + REACH + 0.01, 5);

    assertEquals(List.of(near), filter.believable(state(true, 5, near, far), HELLO, START));
  }

  @Test
  void ofVeryManyAPartIsTaken() {
    Vec2 near = new Vec2(5, 5.5);
    Vec2[] many = Collections.nCopies(2_000, near).toArray(Vec2[]::new);

    assertEquals(
        PerceptFilter.MAX_PERCEPTS, filter.believable(state(true, 5, many), HELLO, START).size());
  }

  @Test
  void aRobotThatDoesNotKnowWhereItIsSeesNothing() {
    assertEquals(List.of(), filter.believable(state(false, 5, new Vec2(5, 5.5)), HELLO, START));
  }

  @Test
  void aRobotThatIsWhereItCannotHaveDrivenIsNotBelievedForAWhile() {
    filter.believable(state(true, 5), HELLO, START);
    Instant jump = START.plusMillis(200);
    Vec2 there = new Vec2(8, 5.5);

    assertEquals(List.of(), filter.believable(state(true, 8, there), HELLO, jump));
    assertEquals(
        List.of(), filter.believable(state(true, 8, there), HELLO, jump.plusMillis(4_900)));
    assertEquals(
        List.of(there), filter.believable(state(true, 8, there), HELLO, jump.plusSeconds(5)));
  }

  @Test
  void whoDrivesAsFastAsItCanIsBelieved() {
    filter.believable(state(true, 5), HELLO, START);
    Vec2 there = new Vec2(6, 5.5);

    // 0.5 m/s for 2 s = 1 m
    assertEquals(
        List.of(there), filter.believable(state(true, 6, there), HELLO, START.plusSeconds(2)));
  }

  @Test
  void aRobotThatWandersFasterThanItDrivesInManySmallJumpsIsNotBelieved() {
    filter.believable(state(true, 5), HELLO, START);

    int believedStates = 0;
    while (believedStates < 100
        && !believed(5.25 + 0.25 * believedStates, START.plusMillis(200L * (believedStates + 1)))
            .isEmpty()) {
      believedStates++;
    }

    // 3 * 0.25 m of 0.5 m + 0.6 s * 0.55 m/s = 0.83 m; 4 * 0.25 m of 0.94 m
    assertEquals(3, believedStates);
  }

  /** States come in bursts, and a mark corrects it by 0.1 m every 10 s. */
  @Test
  void aRobotThatDrivesForLongIsBelievedHoweverUnevenlyItIsHeard() {
    for (int i = 0; i < 3_000; i++) { // 10 minutes
      double seconds = i * 0.2;
      double x = 0.5 * seconds + 0.1 * Math.floor(seconds / 10);
      Instant heard = START.plusMillis(1_000L * Math.floorDiv(i, 5));

      assertEquals(1, believed(x, heard).size(), "after " + i);
    }
  }

  private List<Vec2> believed(double x, Instant now) {
    return filter.believable(state(true, x, new Vec2(x, 5.5)), HELLO, now);
  }

  private static State state(boolean localised, double x, Vec2... obstacles) {
    return new State(
        0,
        localised,
        new Pose(x, 5, 0),
        new Speed(0, 0),
        Mode.IDLE,
        null,
        0,
        Role.ALONE,
        0,
        0,
        0,
        0.5,
        List.of(),
        List.of(obstacles),
        null,
        null,
        List.of());
  }

  private static final Hello HELLO =
      new Hello(
          AgentMessage.VERSION,
          "r1",
          5,
          0.5,
          3.5,
          0.255,
          0.8,
          DriveKind.OMNI.word(),
          0,
          true,
          new Pose(5, 5, 0),
          Mode.IDLE,
          null,
          0,
          Role.ALONE,
          0,
          0,
          0,
          0,
          null);
}
