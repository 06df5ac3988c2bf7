package org.toqa.fleet.dispatch;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalLong;
import java.util.Set;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.allocation.AllocationTask;
import org.toqa.fleet.ChargingRules;
import org.toqa.fleet.FleetRules;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.TaskView;
import org.toqa.fleet.floor.FloorDistances;
import org.toqa.forecast.Charging;
import org.toqa.forecast.Drive;
import org.toqa.forecast.Expectation;
import org.toqa.forecast.FloorForecast;
import org.toqa.forecast.ForecastRobot;
import org.toqa.forecast.ForecastTask;
import org.toqa.forecast.Travel;
import org.toqa.forecast.Unknown;
import org.toqa.forecast.Visit;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.FloorMap;
import org.toqa.grid.Place;
import org.toqa.mission.Stop;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TaskState;

/**
 * A floor at one moment, as a forecast needs it. Immutable, for the thread that computes.
 *
 * @param robots of the floor
 * @param begun tasks that have robots and are not delivered
 * @param queue the first ones of the queue, in their order
 * @param now by the clock
 */
record ForecastPicture(
    FloorMap floor,
    List<RobotView> robots,
    List<TaskView> begun,
    List<Waiting> queue,
    FleetRules rules,
    Instant now) {

  private static final Expectation FAR_BACK = Expectation.none(Unknown.FAR_BACK);

  /** A path that ends nearer, metres, leads there. */
  private static final double THERE = 0.15;

  /** Assumed of a robot that has not said what its battery has, or is not known yet. */
  private static final double UNKNOWN_BATTERY = 0.5;

  /**
   * A task without robots.
   *
   * @param after the task that must be delivered before it begins
   * @param isStopped whether it never begins by itself
   */
  record Waiting(TaskView view, AllocationTask job, OptionalLong after, boolean isStopped) {}

  /**
   * What a robot drives alone.
   *
   * @param seconds that are left of it, if nobody hinders it
   */
  record UnderWay(long task, int stop, boolean isFetched, double seconds) {
    boolean isSameDrive(UnderWay other) {
      return task == other.task && stop == other.stop && isFetched == other.isFetched;
    }
  }

  private record FloorTravel(FloorDistances distances) implements Travel {
    @Override
    public ToDoubleFunction<Vec2> lengthsTo(Vec2 place, double diameter) {
      return distances.lengthsTo(place, diameter);
    }

    @Override
    public Drive drive(Vec2 from, Vec2 to, double diameter) {
      List<Vec2> line = distances.path(from, to, diameter);
      return line.isEmpty() ? Drive.IMPOSSIBLE : Drive.along(line, null);
    }
  }

  Map<Long, Expectation> forecast(FloorDistances distances, double delay) {
    FloorTravel travel = new FloorTravel(distances);
    Map<Long, Expectation> expected = new HashMap<>();
    List<ForecastTask.Queued> near = new ArrayList<>();
    Set<Cell> places = new HashSet<>();
    for (Waiting waiting : queue) {
      waiting.view().placesAhead().forEach(p -> places.add(floor.grid().cellAt(p.position())));
      if (places.size() <= distances.placesKept() / 2) {
        near.add(queued(waiting));
      } else {
        expected.put(waiting.view().id(), FAR_BACK);
      }
    }
    expected.putAll(
        FloorForecast.of(
            robots.stream().filter(r -> r.telemetry().pose() != null).map(this::robot).toList(),
            begun.stream().map(task -> begun(task, travel)).toList(),
            near,
            travel,
            delay,
            charging()));
    return Map.copyOf(expected);
  }

  private Charging charging() {
    ChargingRules charging = rules.charging();
    return new Charging(
        floor.charging().stream().map(Place::position).toList(),
        charging.below(),
        charging.until(),
        charging.toFull().toSeconds());
  }

  private ForecastRobot robot(RobotView robot) {
    Pose pose = Objects.requireNonNull(robot.telemetry().pose());
    Double battery = robot.telemetry().battery();
    String charger = robot.work().charger();
    Vec2 place =
        charger == null || robot.work().phase().isCarryingTask()
            ? pose.position()
            : floor.place(charger).map(Place::position).orElse(pose.position());
    double freeIn = 0;
    if (charger != null && battery != null) {
      freeIn = charging().seconds(battery);
      battery = Math.max(battery, rules.charging().until());
    }
    return new ForecastRobot(
        robot.name(),
        place,
        isUsable(robot) ? freeIn : Double.POSITIVE_INFINITY,
        robot.capabilities().footprint(),
        robot.speed(),
        robot.capabilities().speeds().spotRate(),
        robot.maxLoad(),
        battery);
  }

  private static boolean isUsable(RobotView robot) {
    return !robot.work().held()
        && robot.work().driver() == null
        && (robot.state() == RobotState.IDLE
            || robot.state() == RobotState.DRIVING
            || robot.state() == RobotState.CHARGING);
  }

  private ForecastTask.Begun begun(TaskView task, Travel travel) {
    return new ForecastTask.Begun(
        task.id(),
        task.task().load(),
        visits(task),
        task.state() == TaskState.CARRYING || task.task().isDrive(),
        task.robots(),
        underway(task, travel),
        unknown(task));
  }

  private @Nullable Unknown unknown(TaskView task) {
    if (task.needs() != null) {
      return Unknown.NEEDS_DECISION;
    }
    if (task.held()) {
      return Unknown.ON_HOLD;
    }
    List<RobotView> team =
        robots.stream().filter(robot -> task.robots().contains(robot.name())).toList();
    if (team.stream().anyMatch(robot -> robot.work().held())) {
      return Unknown.ON_HOLD;
    }
    return team.stream().anyMatch(robot -> !isAtWork(robot)) ? Unknown.NO_ROBOT : null;
  }

  /** Also one that stands, or follows. */
  private static boolean isAtWork(RobotView robot) {
    return robot.state().isFit() || robot.state() == RobotState.HOLDING;
  }

  private ForecastTask.Queued queued(Waiting waiting) {
    TaskView task = waiting.view();
    AllocationTask job = waiting.job();
    return new ForecastTask.Queued(
        task.id(),
        task.task().load(),
        visits(task),
        new ChosenRobots(robots).names(task.task().onlyRobots()),
        job.isForOne(),
        waiting.after(),
        rules.pace() * Duration.between(job.waitsFrom(), now).toMillis() / 1000,
        task.held() ? Unknown.ON_HOLD : waiting.isStopped() ? Unknown.NEEDS_DECISION : null);
  }

  /** Where it still has to come, and how long it waits there. */
  private List<Visit> visits(TaskView task) {
    List<Stop> route = task.task().route();
    List<Visit> visits = new ArrayList<>();
    if (task.state() != TaskState.CARRYING) {
      int first = task.task().stopAfterFirst(task.progress()) - 1;
      boolean isAtStop = task.progress().stop() == first && task.loadAt() == null;
      visits.add(
          new Visit(
              task.object().position(), isAtStop ? waitSeconds(task, route.get(first), first) : 0));
    }
    for (int i = task.task().stopAfterFirst(task.progress()); i < route.size(); i++) {
      visits.add(new Visit(route.get(i).place().position(), waitSeconds(task, route.get(i), i)));
    }
    return visits;
  }

  /** What is left, where its robots wait there. */
  private double waitSeconds(TaskView task, Stop stop, int number) {
    if (!stop.hasWait()) {
      return 0;
    }
    Duration waited =
        task.progress().stop() == number
            ? task.progress().waited(now, rules.pace())
            : Duration.ZERO;
    double time =
        stop.waitLeft(waited)
            .map(left -> Math.max(0, left.toMillis() / 1000.0))
            .orElse(Double.POSITIVE_INFINITY);
    return Math.min(time, chargeSeconds(task, stop));
  }

  /** Until its robot has charged as far as was ordered; infinite where that ends no wait. */
  private double chargeSeconds(TaskView task, Stop stop) {
    double battery =
        robots.stream()
            .filter(robot -> task.robots().contains(robot.name()))
            .map(robot -> robot.telemetry().battery())
            .filter(Objects::nonNull)
            .findFirst()
            .orElse(UNKNOWN_BATTERY);
    return stop.chargesUntil(rules.charging().until())
        .map(level -> Math.max(0, level - battery) * rules.charging().toFull().toSeconds())
        .orElse(Double.POSITIVE_INFINITY);
  }

  /**
   * On the path that its leader has, and from where that ends; nothing while it waits at a stop.
   */
  private Drive underway(TaskView task, Travel travel) {
    if (task.isWaitingAtStop()) {
      return Drive.NONE;
    }
    return robots.stream()
        .filter(robot -> !task.robots().isEmpty())
        .filter(robot -> robot.name().equals(task.robots().getFirst()))
        .findFirst()
        .map(robot -> drive(robot, task, travel))
        .orElse(Drive.IMPOSSIBLE);
  }

  private static Drive drive(RobotView robot, TaskView task, Travel travel) {
    Pose pose = robot.telemetry().pose();
    TaskPlace target = task.placesAhead().getFirst();
    boolean isForIt = Objects.equals(robot.work().task(), task.id());
    if (pose == null) {
      return Drive.IMPOSSIBLE;
    }
    boolean isOnItsPath = isForIt && !robot.pathPoints().isEmpty();
    List<Vec2> line = isOnItsPath ? robot.pathPoints() : List.of(pose.position());
    Drive drive = Drive.along(line, pose.theta());
    Vec2 end = line.getLast();
    return end.distanceTo(target.position()) < THERE
        ? drive
        : drive.plus(travel.drive(end, target.position(), robot.capabilities().footprint()));
  }

  /** By name, the robots that drive for a task alone, and are not kept by a person. */
  Map<String, UnderWay> underWay(FloorDistances distances) {
    FloorTravel travel = new FloorTravel(distances);
    Map<String, RobotView> byName =
        robots.stream().collect(Collectors.toMap(RobotView::name, robot -> robot));
    return begun.stream()
        .filter(task -> task.robots().size() == 1 && !task.isWaitingAtStop())
        .filter(task -> !task.isChargingNext()) // it may wait for others first
        .filter(task -> task.state() == TaskState.TO_OBJECT || task.state() == TaskState.CARRYING)
        .filter(task -> unknown(task) == null)
        .flatMap(
            task ->
                Stream.ofNullable(byName.get(task.robots().getFirst()))
                    .filter(robot -> robot.telemetry().pose() != null)
                    .map(robot -> Map.entry(robot.name(), underWay(task, robot, travel))))
        .filter(entry -> Double.isFinite(entry.getValue().seconds()))
        .collect(Collectors.toUnmodifiableMap(Map.Entry::getKey, Map.Entry::getValue));
  }

  private static UnderWay underWay(TaskView task, RobotView robot, Travel travel) {
    Drive drive = drive(robot, task, travel);
    return new UnderWay(
        task.id(),
        task.progress().stop(),
        task.state() == TaskState.CARRYING,
        drive.seconds(robot.speed(), robot.capabilities().speeds().spotRate()));
  }
}
