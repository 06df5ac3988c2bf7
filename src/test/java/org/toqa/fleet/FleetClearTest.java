package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.ServerMessage.Clear;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.TaskState;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** Robots that their own hardware stopped. */
class FleetClearTest extends HallFleetTest {
  private static final Set<String> SWITCH = Set.of("STOP_SWITCH");

  private long task;
  private Vec2 stopped = new Vec2(0, 0);

  private void carryAndStop() throws Exception {
    task = submit("West", "East");
    untilCarryingOnTheWay(task);
    scriptedRobot("r1").stopItself("STOP_SWITCH");
    until(view -> robot(view, "r1").state() == RobotState.ERROR);
    stopped = scriptedRobot("r1").position();
  }

  @Test
  void aPersonsWordForTheRobotLetsItGoOnWithItsTask() throws Exception {
    carryAndStop();
    accepted(stage.fleet.clearStops("r1", SWITCH, "Max"));

    until(view -> task(view, task).state() == TaskState.DONE);
    assertEquals(List.of(List.of("STOP_SWITCH")), clears());
    assertEquals(
        List.of("Max cleared what had stopped r1: STOP_SWITCH"), history("robot.stop-cleared"));
  }

  @Test
  void whoseStopEndsAtTheRobotGetsANewDriveWithoutAWord() throws Exception {
    task = submit("West", "East");
    untilCarryingOnTheWay(task);
    scriptedRobot("r1").breakDown("EMERGENCY");
    until(view -> robot(view, "r1").state() == RobotState.ERROR);
    scriptedRobot("r1").endStop();

    until(view -> task(view, task).state() == TaskState.DONE);
    assertEquals(List.of(), clears());
  }

  @Test
  void noResumeClearsAnything() throws Exception {
    carryAndStop();
    accepted(stage.fleet.pauseAll("Max"));
    accepted(stage.fleet.resumeAll("Max"));
    accepted(stage.fleet.holdRobot("r1", "Max"));
    accepted(stage.fleet.resumeRobot("r1", "Max"));
    accepted(stage.fleet.commandTask(task, new MissionEvent.Hold("Max")));
    accepted(stage.fleet.commandTask(task, new MissionEvent.Resume("Max")));
    stage.pass(Duration.ofSeconds(2));

    assertEquals(List.of(), clears());
    assertEquals(RobotState.ERROR, robot(stage.fleet.snapshots().latest(), "r1").state());
    assertEquals(stopped, scriptedRobot("r1").position());
  }

  @Test
  void whatHasChangedMeanwhileIsNotCleared() throws Exception {
    carryAndStop();
    assertConflict(
        Phrase.STOPS_HAVE_CHANGED.with("r1", "It has stopped itself."), Set.of("STOP_EDGE"));
    scriptedRobot("r1").repair();
    until(view -> robot(view, "r1").state() != RobotState.ERROR);
    assertConflict(Phrase.NOTHING_TO_CLEAR.with("r1"), SWITCH);
    assertEquals(List.of(), clears());
  }

  @Test
  void aRobotThatIsNotHeardIsNotCleared() throws Exception {
    carryAndStop();
    scriptedRobot("r1").fallSilent();
    until(view -> robot(view, "r1").state() == RobotState.LOST);

    assertConflict(Phrase.CLEAR_WHEN_CONNECTED.with("r1"), SWITCH);
    scriptedRobot("r1").speakAgain();
    until(view -> robot(view, "r1").state() == RobotState.ERROR);
    assertEquals(List.of(), clears());
  }

  @Test
  void whatTheRobotRefusesToClearIsToldAndItsDriveStays() throws Exception {
    carryAndStop();
    int told = scriptedRobot("r1").obeyed().size();
    scriptedRobot("r1").refuseToClear();
    accepted(stage.fleet.clearStops("r1", SWITCH, "Max"));
    stage.pass(Duration.ofSeconds(2));

    assertEquals(told, scriptedRobot("r1").obeyed().size(), "it is told nothing else");
    assertTrue(scriptedRobot("r1").isDriving());
    assertEquals(
        List.of("r1 refused a command: What stops the robot has changed."),
        history("robot.stop-not-cleared"));
  }

  @Test
  void aClearThatIsLostIsSentAgain() throws Exception {
    carryAndStop();
    scriptedRobot("r1").loseClears(2);
    accepted(stage.fleet.clearStops("r1", SWITCH, "Max"));

    until(view -> task(view, task).state() == TaskState.DONE);
    assertEquals(List.of(List.of("STOP_SWITCH")), clears());
    assertEquals(List.of(), history("robot.stop-not-cleared"));
  }

  @Test
  void aClearThatIsNeverAnsweredIsGivenUpAndTold() throws Exception {
    carryAndStop();
    scriptedRobot("r1").loseClears(100);
    accepted(stage.fleet.clearStops("r1", SWITCH, "Max"));

    untilHistory(
        "robot.stop-not-cleared",
        "r1 did not answer, so its stop is not cleared. Look at the robot again, then clear it"
            + " again.");
    scriptedRobot("r1").loseClears(0);
    stage.pass(Duration.ofSeconds(10));
    assertEquals(List.of(), clears(), "later it is not sent");
    assertEquals(1, history("robot.stop-not-cleared").size());
  }

  @Test
  void aClearThatWentWithItsConnectionIsNotSentOverTheNext() throws Exception {
    carryAndStop();
    scriptedRobot("r1").loseClears(1);
    accepted(stage.fleet.clearStops("r1", SWITCH, "Max"));
    scriptedRobot("r1").loseConnection();
    stage.awaitQuiescence();
    scriptedRobot("r1").speakAgain();

    until(view -> history("robot.stop-not-cleared").size() == 1);
    stage.pass(Duration.ofSeconds(10));
    assertEquals(List.of(), clears());
    assertEquals(1, history("robot.stop-not-cleared").size());
  }

  @Test
  void aStopWhoseCauseLastsIsToldToWhoClearedIt() throws Exception {
    carryAndStop();
    accepted(stage.fleet.clearStops("r1", SWITCH, "Max"));
    until(view -> !clears().isEmpty());
    scriptedRobot("r1").stopItself("STOP_SWITCH");

    untilHistory(
        "robot.stop-not-cleared",
        "r1 is still stopped although it was cleared (STOP_SWITCH): the cause is still there, or"
            + " it stopped again. Look at the robot again.");
  }

  @Test
  void robotsThatAreUnknownHaveNoStops() throws Exception {
    assertEquals(
        new Answer.Unknown<>(Phrase.NO_SUCH_ROBOT.with("r7")),
        answer(stage.fleet.clearStops("r7", SWITCH, "Max")));
  }

  private List<List<String>> clears() {
    return scriptedRobot("r1").obeyed().stream()
        .filter(Clear.class::isInstance)
        .map(command -> ((Clear) command).reasons())
        .toList();
  }

  private void assertConflict(Sentence sentence, Set<String> reasons) throws Exception {
    Answer<RobotView> answer = answer(stage.fleet.clearStops("r1", reasons, "Max"));
    assertEquals(sentence, assertInstanceOf(Answer.Conflict.class, answer).sentence());
  }
}
