package org.toqa.fleet.floor;

import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Answer;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.FleetRuntime;
import org.toqa.fleet.FleetStore;
import org.toqa.fleet.FloorView.ChargerShortage;
import org.toqa.fleet.Hold;
import org.toqa.fleet.RobotMessageKind;
import org.toqa.fleet.StoreWriter;
import org.toqa.fleet.floor.FloorWatch.HistoryLine;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.Place;
import org.toqa.mission.Mission;
import org.toqa.mission.TaskState;
import org.toqa.traffic.floor.FloorTraffic;
import org.toqa.traffic.floor.RobotMap;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** The floor as it is now, which the parts of its agent share. Confined to that agent. */
public final class FloorState {
  /** Metres; whoever is so near to a place is there. */
  static final double ARRIVAL_DISTANCE = 0.15;

  final FloorMap floor;
  final FleetStore store;
  final StoreWriter writer;
  final InstantSource clock;
  final FleetRuntime runtime;
  final FloorTraffic traffic;
  final ChargerWatch chargers;
  final Map<String, FloorRobot> robots = new RobotMap<>();
  final OpenMissions missions = new OpenMissions();
  final LeftLoads leftLoads;
  final Formations formations;

  /** By an operator, of all its robots; null: they may drive. */
  @Nullable Hold hold;

  /** Null: the charging points are enough, as far as is known. */
  @Nullable ChargerShortage chargerShortage;

  /** Of the time that ticks bring. */
  Instant now;

  /** Whether there is something new to report. */
  boolean changed = true;

  FloorState(
      FloorMap floor,
      FleetStore store,
      InstantSource clock,
      FloorTraffic traffic,
      ChargerWatch chargers,
      Instant now,
      FleetRuntime runtime,
      Consumer<Sentence> onLeftOut) {
    this.floor = floor;
    this.store = store;
    this.writer =
        new StoreWriter("floor-" + floor.name(), runtime, store::inOneTransaction, onLeftOut);
    this.clock = clock;
    this.runtime = runtime;
    this.traffic = traffic;
    this.chargers = chargers;
    this.now = now;
    this.leftLoads = new LeftLoads(floor.grid());
    this.formations = new Formations(this);
  }

  /** The robot's parking point. */
  Optional<Vec2> parkingPoint(String robot) {
    return Optional.ofNullable(robots.get(robot))
        .map(r -> r.record().parking())
        .flatMap(floor::place)
        .map(Place::position);
  }

  /**
   * Across what a robot covers wherever it turns, with what it carries alone, metres. A load whose
   * size nobody said does not stand out from it.
   */
  double diameter(FloorRobot robot) {
    return diameter(robot, robot.reported.footprint());
  }

  /**
   * The same of one that may not have said what it covers yet.
   *
   * @param own across the robot alone, metres, or what was kept for it before
   */
  double diameter(FloorRobot robot, double own) {
    return missions
        .missionOf(robot.name())
        .filter(mission -> mission.state() == TaskState.CARRYING)
        .filter(mission -> mission.assignedRobots().size() == 1)
        .map(mission -> mission.task().size())
        .map(size -> Math.max(own, size.diameter()))
        .orElse(own);
  }

  boolean isAt(FloorRobot robot, Vec2 place) {
    Pose pose = robot.reported.pose();
    return pose != null
        && (pose.position().distanceTo(place) < ARRIVAL_DISTANCE
            || floor.grid().cellAt(pose.position()).equals(floor.grid().cellAt(place)));
  }

  /** Where the charging point of that name is, if there is one. */
  Optional<Vec2> chargingPoint(String name) {
    return floor.charging().stream()
        .filter(point -> point.name().equals(name))
        .map(Place::position)
        .findFirst();
  }

  /** Whether its cells stay reserved though nothing is heard from it. */
  boolean hasReservedCells(FloorRobot robot) {
    return !robot.isHeard() && traffic.hasRobot(robot.name());
  }

  /** A line for the history of the robot and of the task that it works for. */
  EventRecord historyEvent(EventKind kind, String robot, String who, Sentence text) {
    Long task = missions.missionOf(robot).map(Mission::id).orElse(null);
    return new EventRecord(clock.instant(), kind, task, robot, who, text).onFloor(floor.name());
  }

  void addToHistory(EventRecord event) {
    writer.write(() -> store.addEvents(List.of(event)), () -> {});
  }

  void addToHistory(List<HistoryLine> remarks) {
    for (HistoryLine remark : remarks) {
      changed = true;
      addToHistory(historyEvent(remark.kind(), remark.robot(), EventRecord.SYSTEM, remark.text()));
    }
  }

  /** The same of what robots saw or said: of one that causes very many, a part. */
  void addRobotLines(List<HistoryLine> lines) {
    addToHistory(lines.stream().filter(line -> mayAddLine(line.robot())).toList());
  }

  /** Whether the history takes one more line that this robot causes. */
  boolean mayAddLine(String robot) {
    FloorRobot cause = robots.get(robot);
    return switch (cause == null ? StoreLimit.Verdict.WRITE : cause.storing.judgeLine()) {
      case WRITE -> true;
      case LEAVE_OUT -> false;
      case LEAVE_OUT_AND_TELL -> {
        addFlood(robot, RobotMessageKind.EVENT);
        yield false;
      }
    };
  }

  /** Tells people that a robot says too much. */
  void addFlood(String robot, RobotMessageKind kind) {
    addSystemLine(
        EventKind.ROBOT_SENDS_TOO_MUCH,
        robot,
        Phrase.SENDS_TOO_MUCH.with(robot, kind.phrase().with()));
  }

  /** A line that this program adds by itself. */
  void addSystemLine(EventKind kind, String robot, Sentence text) {
    addToHistory(historyEvent(kind, robot, EventRecord.SYSTEM, text));
  }

  public static <T> Answer<T> unknownRobot(String robot) {
    return new Answer.Unknown<>(Phrase.NO_SUCH_ROBOT_HERE.with(robot));
  }

  /** Why the store does not answer, or null while it does. */
  @Nullable String storeTrouble() {
    return writer.trouble();
  }
}
