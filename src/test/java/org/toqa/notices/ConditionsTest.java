package org.toqa.notices;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.FloorView;
import org.toqa.fleet.Hold;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.geometry.Pose;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.testbed.Hall;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

class ConditionsTest {
  private static final Instant NOW = Instant.parse("2026-11-27T08:00:00Z");

  private static RobotView robot(RobotState state) {
    return Hall.robot("r1", state, new Pose(1, 1, 0), "127.0.0.1", 7275);
  }

  private static RobotView withFaults(RobotState state, Fault... faults) {
    RobotView robot = robot(state);
    return robot.withTelemetry(robot.telemetry().withErrors(List.of(faults)));
  }

  private static List<Condition> of(
      List<RobotView> robots, List<FloorView> floors, @Nullable Hold pause, Sentence... alerts) {
    return Conditions.of(
        new FleetSnapshot(
            1, NOW, robots, List.of(), 0, floors, pause, Map.of(), Map.of(), List.of(alerts)));
  }

  private static List<Condition> ofRobot(RobotView robot) {
    return of(List.of(robot), List.of(), null);
  }

  private static String only(RobotView robot) {
    List<Condition> found = ofRobot(robot);
    assertEquals(1, found.size(), found::toString);
    Condition one = found.getFirst();
    assertEquals("r1", one.robot());
    assertEquals("hall", one.floor());
    return one.kind().word() + ": " + one.english();
  }

  @Test
  void aRobotAtWorkNeedsNobody() {
    for (RobotState state :
        Set.of(RobotState.IDLE, RobotState.DRIVING, RobotState.CHARGING, RobotState.HOLDING)) {
      assertEquals(List.of(), ofRobot(robot(state)), state::name);
    }
    assertEquals(List.of(), ofRobot(robot(RobotState.CONNECTING)));
  }

  @Test
  void whatIsWrongWithARobotHasAKind() {
    assertEquals("robot-lost: r1: lost, nothing is heard of it", only(robot(RobotState.LOST)));
    assertEquals(
        "robot-not-localised: r1: does not know where it is; say it on its page",
        only(robot(RobotState.NOT_LOCALISED)));
    assertEquals(
        "robot-lost: r1: refused",
        only(robot(RobotState.CONNECTING).withUnreachable(Sentence.verbatim("refused"))));
    assertEquals(
        "robot-error: r1: the wheel slips",
        only(withFaults(RobotState.ERROR, new Fault("SLIP", "the wheel slips"))));
    assertEquals(
        "robot-stopped: r1: the button was pressed",
        only(withFaults(RobotState.ERROR, new Fault("ESTOP", "the button was pressed", true))));
    assertEquals(
        "robot-battery: r1: Must charge, but finds no path to a charger",
        only(robot(RobotState.IDLE).withAlert(Phrase.NO_WAY_TO_CHARGER.with())));
    assertEquals(
        "robot-battery: r1: Has 4 %, which hardly lasts to deliver the load of task 7 and reach a"
            + " charger",
        only(robot(RobotState.IDLE).withAlert(Phrase.HARDLY_LASTS_FOR_LOAD.with(4, 7))));
  }

  @Test
  void eachFaultIsOneOfItsOwn() {
    assertEquals(
        2,
        ofRobot(withFaults(RobotState.ERROR, new Fault("A", "a"), new Fault("B", "b"))).stream()
            .map(Condition::key)
            .distinct()
            .count());
  }

  @Test
  void aReadingThatGoesOnChangingIsOneCondition() {
    List<Condition.Key> keys =
        List.of(61.0, 62.5).stream()
            .map(
                degrees ->
                    robot(RobotState.IDLE)
                        .withAlert(Phrase.READING_ABOVE.with("temperature", degrees, " C", 60.0)))
            .flatMap(robot -> ofRobot(robot).stream())
            .map(Condition::key)
            .toList();

    assertEquals(keys.get(0), keys.get(1));
    assertEquals(NoticeKind.ROBOT_READING, keys.getFirst().kind());
  }

  @Test
  void aRobotOutOfServiceWasSeenToByAPerson() {
    assertEquals(
        List.of(), ofRobot(withFaults(RobotState.OUT_OF_SERVICE, new Fault("SLIP", "it slips"))));
  }

  @Test
  void whatIsWrongWithTheFloorAndTheServerIsFound() {
    Set<String> kinds =
        of(
                List.of(),
                List.of(Hall.crowdedFloor()),
                new Hold("Max", NOW),
                Phrase.DATABASE_AWAY.with())
            .stream()
            .map(condition -> condition.kind().word())
            .collect(Collectors.toCollection(TreeSet::new));

    assertEquals(
        Set.of("charger-faulty", "chargers-short", "fleet-paused", "server", "standstill"), kinds);
  }
}
