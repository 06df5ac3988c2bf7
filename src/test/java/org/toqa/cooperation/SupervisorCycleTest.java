package org.toqa.cooperation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.toqa.cooperation.CarryCommand.AskForWorker;
import org.toqa.cooperation.CarryCommand.Carry;
import org.toqa.cooperation.CarryCommand.Charge;
import org.toqa.cooperation.CarryCommand.GoToBox;
import org.toqa.cooperation.CarryCommand.Park;
import org.toqa.cooperation.CarryCommand.Search;
import org.toqa.cooperation.CarryCommand.Wait;
import org.toqa.cooperation.CarryEvent.BoxDelivered;
import org.toqa.cooperation.CarryEvent.BoxSeen;
import org.toqa.cooperation.CarryEvent.BoxUnreachable;
import org.toqa.cooperation.CarryEvent.BoxWeighed;
import org.toqa.cooperation.CarryEvent.MapGrown;
import org.toqa.cooperation.CarryEvent.RobotCharged;
import org.toqa.cooperation.CarryEvent.RobotReported;
import org.toqa.cooperation.CarryEvent.SecondArrived;
import org.toqa.cooperation.CarryEvent.StoreSeen;
import org.toqa.cooperation.CarryEvent.WorkerBack;
import org.toqa.cooperation.CarryEvent.WorkerLost;
import org.toqa.cooperation.KnownBox.Stage;
import org.toqa.geometry.Vec2;

class SupervisorCycleTest {
  private static final CarryRules RULES = new CarryRules(5, 0.2, CarryRules.WORK_TIME, true);
  private static final List<Vec2> STATIONS = List.of(new Vec2(0, 0), new Vec2(100, 0));

  private CarryRules rules = RULES;
  private CarryState state = CarryState.begin("R3", List.of("R1", "R2"), STATIONS);

  private List<CarryCommand> tell(CarryEvent event) {
    SupervisorCycle.Step step = SupervisorCycle.next(rules, state, event);
    state = step.state();
    return step.commands();
  }

  private void report(String robot, double x, double battery) {
    tell(new RobotReported(robot, new Vec2(x, 0), battery, 0, null));
  }

  private void begin() {
    report("R1", 10, 1);
    report("R2", 90, 1);
    tell(new WorkerBack("R1", null, null));
    tell(new WorkerBack("R2", null, null));
  }

  private List<CarryCommand> see(int box, double x) {
    return tell(new BoxSeen("R3", box, new Vec2(x, 0), false));
  }

  @Test
  void aBoxGoesToTheNearestWorkerAndTheNextOneIsLookedForMeanwhile() {
    assertEquals(List.of(new Search("R3", false)), tell(new WorkerBack("R1", null, null)));
    begin();

    assertEquals(List.of(new GoToBox("R2", 1, false)), see(1, 80));
    assertEquals(List.of(new GoToBox("R1", 2, false)), see(2, 85));
    assertEquals(List.of(), see(3, 20), "nobody is free");
    assertEquals(List.of(new Carry(List.of("R2"), 1)), tell(new BoxWeighed("R2", 5)));
    assertEquals(List.of(new GoToBox("R2", 3, false)), tell(new BoxDelivered(1)));
  }

  @Test
  void withoutOverlapTheSupervisorWaitsForItsWorkers() {
    rules = new CarryRules(5, 0.2, CarryRules.WORK_TIME, false);
    begin();

    assertEquals(List.of(new GoToBox("R1", 1, false), new Wait("R3")), see(1, 20));
    tell(new BoxWeighed("R1", 1));
    assertEquals(List.of(new Search("R3", false)), tell(new BoxDelivered(1)));
  }

  @Test
  void twoCarryWhatIsOverTheThreshold() {
    begin();
    see(1, 20);

    assertEquals(List.of(new GoToBox("R2", 1, true)), tell(new BoxWeighed("R1", 5.01)));
    assertEquals(List.of(new Carry(List.of("R1", "R2"), 1)), tell(new SecondArrived("R2")));
  }

  @Test
  void whoWouldWaitForEachOtherHelp() {
    begin();
    see(1, 20);
    see(2, 80);
    tell(new BoxWeighed("R1", 6));

    assertEquals(List.of(new GoToBox("R2", 1, true)), tell(new BoxWeighed("R2", 6)));
    assertEquals(Stage.FOUND, state.box(2).stage());
    tell(new SecondArrived("R2"));
    assertEquals(List.of(new GoToBox("R2", 2, false)), tell(new BoxDelivered(1)));
    assertEquals(List.of(new GoToBox("R1", 2, true)), tell(new BoxWeighed("R2", 6)));
  }

  @Test
  void aSupervisorThatIsLowChargesFirst() {
    begin();
    report("R3", 60, 0.2);

    assertEquals(List.of(), see(1, 20));
    assertTrue(state.occupied().containsValue("R3"));
    report("R3", 100, 1);
    List<CarryCommand> commands = tell(new RobotCharged("R3"));
    assertEquals(List.of(new GoToBox("R1", 1, false), new Search("R3", false)), commands);
  }

  @Test
  void lowWorkersGoToDifferentStationsAndTheThirdRobotWaits() {
    begin();
    assertEquals(
        List.of(new Charge("R1", 0)), tell(new RobotReported("R1", new Vec2(10, 0), 0.1, 0, null)));
    assertEquals(
        List.of(new Charge("R2", 1)),
        tell(new RobotReported("R2", new Vec2(20, 0), 1, CarryRules.WORK_TIME, null)));
    assertEquals(
        List.of(new Wait("R3")), tell(new RobotReported("R3", new Vec2(50, 0), 0.1, 0, null)));

    report("R1", 0, 1);
    assertEquals(List.of(new Park("R1"), new Charge("R3", 0)), tell(new RobotCharged("R1")));
  }

  @Test
  void aBoxWithoutAPathIsTriedAgainWhenTheMapHasGrown() {
    begin();
    see(1, 20);

    assertEquals(List.of(), tell(new BoxUnreachable("R1")));
    assertEquals(List.of(new GoToBox("R1", 1, false)), tell(new MapGrown()));
  }

  @Test
  void theBoxInTheArmOfALostWorkerIsLookedForEverywhere() {
    begin();
    tell(new StoreSeen("R3"));
    see(1, 20);
    tell(new BoxWeighed("R1", 1));

    assertEquals(List.of(new Search("R3", true)), tell(new WorkerLost("R1")));
    assertFalse(state.isDone());
    assertEquals(List.of(new GoToBox("R2", 1, false)), see(1, 50));
  }

  @Test
  void aPersonIsAskedWhereOneWorkerIsLeftForABoxForTwo() {
    begin();
    see(1, 20);
    tell(new BoxWeighed("R1", 6));

    assertTrue(tell(new WorkerLost("R2")).contains(new AskForWorker(1)));
    assertEquals(List.of(), tell(new MapGrown()), "once");
    assertEquals(List.of(new GoToBox("R2", 1, true)), tell(new WorkerBack("R2", null, null)));
  }

  @Test
  void aSupervisorThatStartsAnewHearsWhatItsWorkersHold() {
    report("R1", 10, 1);
    report("R2", 12, 1);
    tell(new WorkerBack("R1", 7, "R2"));

    assertEquals(List.of(new Carry(List.of("R1", "R2"), 7)), tell(new WorkerBack("R2", 7, "R1")));
    tell(new BoxDelivered(7));
    tell(new BoxSeen("R3", 8, new Vec2(5, 5), true));
    assertFalse(state.isDone());
    tell(new StoreSeen("R3"));
    assertTrue(state.isDone());
  }

  @Test
  void withoutASupervisorAWorkerTakesOnlyWhatItHasSeenItself() {
    state = CarryState.begin(null, List.of("R1", "R2"), STATIONS);
    begin();

    assertEquals(
        List.of(new GoToBox("R1", 1, false)), tell(new BoxSeen("R1", 1, new Vec2(88, 0), false)));
    assertEquals(List.of(), tell(new BoxSeen("R2", 1, new Vec2(88, 0), false)));
    assertEquals(List.of(), tell(new BoxSeen("R1", 2, new Vec2(89, 0), false)));
    assertEquals(
        List.of(new GoToBox("R2", 2, false)), tell(new BoxSeen("R2", 2, new Vec2(89, 0), false)));
  }
}
