package org.toqa.mission;

import java.time.Instant;
import java.util.List;
import java.util.Set;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.Tuple;
import org.toqa.geometry.Vec2;
import org.toqa.wording.Sentence;

/** What may happen to a task, in any order and however often. */
public final class MissionEvents {
  /** Where robots stop and loads stand. */
  public static final TaskPlace SPOT = new TaskPlace(new Vec2(3, 1.5), null);

  private static final MissionEvent.LoadState ONE_DRIVES =
      new MissionEvent.LoadState(SPOT, Set.of("r1"));

  private MissionEvents() {}

  /** As the manager does; a task on hold waits. */
  public static Mission givenToRobots(Mission mission) {
    return mission.state() == TaskState.QUEUED && !mission.held()
        ? mission.assign(List.of("r1", "r2"), Sentence.verbatim("heavy")).mission()
        : mission;
  }

  public static Arbitrary<List<MissionEvent>> upTo(int length) {
    return upTo(length, 1);
  }

  /**
   * @param driving how many times as often as usual robots come where they drive
   */
  static Arbitrary<List<MissionEvent>> upTo(int length, int driving) {
    Arbitrary<String> robots = Arbitraries.of("r1", "r2", "unassigned");
    Arbitrary<Phase> phases = Arbitraries.of(Phase.TO_OBJECT, Phase.TO_GOAL, Phase.HOME);
    Arbitrary<TaskPlace> places = Arbitraries.just(SPOT).injectNull(0.3);
    Arbitrary<MissionEvent> started =
        Combinators.combine(robots, phases).as(MissionEvent.DriveStarted::new);
    Arbitrary<MissionEvent> ended =
        Combinators.combine(robots, phases, Arbitraries.integers().between(0, 3))
            .as(
                (robot, phase, stop) ->
                    new MissionEvent.PhaseEnded(robot, phase, stop, Instant.EPOCH));
    Arbitrary<MissionEvent> failures =
        Combinators.combine(robots, places)
            .flatAs(
                (robot, place) ->
                    Arbitraries.of(
                        new MissionEvent.RobotFailed(
                            robot, Sentence.verbatim("reports an error"), place),
                        new MissionEvent.RobotLost(robot, place),
                        new MissionEvent.RobotWithdrawn(robot, place)));
    Arbitrary<MissionEvent> others =
        robots.flatMap(
            robot ->
                Arbitraries.of(
                    new MissionEvent.RobotRecovered(robot),
                    new MissionEvent.Retasked(robot),
                    new MissionEvent.ChargingRequired(
                        robot, Sentence.verbatim("its battery has 10 %")),
                    new MissionEvent.Exchanged(robot, "r3", Sentence.verbatim("nearer")),
                    new MissionEvent.Stopped(robot, SPOT)));
    Arbitrary<MissionEvent> commands =
        Arbitraries.of(
            new MissionEvent.Hold("max"),
            new MissionEvent.Resume("max"),
            new MissionEvent.Resume("max", true),
            new MissionEvent.Prioritise("max", 7),
            new MissionEvent.GoOn("max", null),
            new MissionEvent.GoOn("max", 1),
            new MissionEvent.GoOn("max", 2),
            new MissionEvent.Cancel("max", null),
            new MissionEvent.Cancel("max", LoadChoice.HERE),
            new MissionEvent.Cancel("max", LoadChoice.BACK),
            new MissionEvent.Answer("max", Reply.ANOTHER),
            new MissionEvent.Answer("max", Reply.WAIT),
            new MissionEvent.Answer("max", Reply.CANCEL),
            new MissionEvent.Answer("max", Reply.CANCEL).given(ONE_DRIVES));
    Arbitrary<MissionEvent> goOn = Arbitraries.just(new MissionEvent.GoOn("max", null));
    Arbitrary<MissionEvent> waits =
        Arbitraries.integers()
            .between(0, 3)
            .flatMap(
                stop ->
                    Arbitraries.of(
                        new MissionEvent.WaitEnded(stop), new MissionEvent.ChargeEnded(stop, 0.9)));
    return Arbitraries.frequencyOf(
            Tuple.of(1, started),
            Tuple.of(12 * driving, ended),
            Tuple.of(driving, waits),
            Tuple.of(driving, goOn),
            Tuple.of(2, failures),
            Tuple.of(2, others),
            Tuple.of(2, commands))
        .list()
        .ofMaxSize(length);
  }
}
