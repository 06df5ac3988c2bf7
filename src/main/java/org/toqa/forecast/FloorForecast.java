package org.toqa.forecast;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.ToDoubleFunction;
import org.jspecify.annotations.Nullable;
import org.toqa.allocation.Energy;
import org.toqa.geometry.Vec2;

/**
 * When the tasks of a floor will be picked up and delivered: list scheduling (Graham, "Bounds on
 * multiprocessing timing anomalies", 1969) over its robots. Each robot first ends what it has;
 * then, one after the other, the task goes to the robot that could begin it first, where a second
 * of waiting makes up for as much of a detour as with {@code optimal}. A drive takes the length of
 * its path over the speed, and its turns over their rate, times the delay measured lately.
 *
 * <p>A function of values. With n queued tasks and m robots it asks for n * n * m / 2 lengths of
 * paths at most.
 */
public final class FloorForecast {
  /**
   * What a task gains by a second of waiting, metres, as in {@code allocation.OptimalAllocator}.
   */
  private static final double METRES_PER_SECOND_WAITED = 0.1;

  /** Kilograms; sums of what robots carry are not exact. */
  private static final double ROUNDING = 1e-9;

  private final Travel travel;
  private final double delay;
  private final Charging charging;
  private final Map<String, Slot> slots = new HashMap<>();
  private final List<Slot> inOrder = new ArrayList<>();
  private final Map<Long, Expectation> expected = new HashMap<>();
  private final Map<Approach, ToDoubleFunction<Vec2>> approaches = new HashMap<>();

  private record Approach(Vec2 place, double diameter) {}

  /** A robot, and from when on and where it is free. */
  private static final class Slot {
    final ForecastRobot robot;
    double at;
    Vec2 place;
    @Nullable Double battery;

    Slot(ForecastRobot robot) {
      this.robot = robot;
      this.at = robot.freeIn();
      this.place = robot.place();
      this.battery = robot.battery();
    }
  }

  /**
   * Who would carry a task.
   *
   * @param pickUp when they could be there, seconds
   * @param score the least is taken first
   */
  private record Choice(ForecastTask.Queued task, List<Slot> team, double pickUp, double score) {}

  /**
   * What came out for one task.
   *
   * @param end when its robots are free, seconds; infinite where that is not known
   * @param metres that they drove
   */
  private record Course(Expectation expectation, double end, double metres) {}

  private FloorForecast(Travel travel, double delay, Charging charging) {
    this.travel = travel;
    this.delay = delay;
    this.charging = charging;
  }

  /**
   * @param robots of the floor
   * @param begun tasks that have robots
   * @param queued tasks that have none, in their order
   * @param delay factor by which drives take longer than on an empty floor
   * @return for each task what can be said of it
   */
  public static Map<Long, Expectation> of(
      List<ForecastRobot> robots,
      List<ForecastTask.Begun> begun,
      List<ForecastTask.Queued> queued,
      Travel travel,
      double delay,
      Charging charging) {
    FloorForecast forecast = new FloorForecast(travel, delay, charging);
    for (ForecastRobot robot : robots) {
      Slot slot = new Slot(robot);
      forecast.slots.put(robot.name(), slot);
      forecast.inOrder.add(slot);
    }
    begun.forEach(forecast::end);
    forecast.serve(queued);
    return Map.copyOf(forecast.expected);
  }

  private void end(ForecastTask.Begun task) {
    List<Slot> team = task.robots().stream().map(slots::get).filter(s -> s != null).toList();
    Course course =
        team.isEmpty()
            ? new Course(Expectation.none(Unknown.NO_ROBOT), Double.POSITIVE_INFINITY, 0)
            : task.unknown() == null
                ? course(team, 0, task.underway(), task.visits(), !task.isFetched())
                : new Course(Expectation.none(task.unknown()), Double.POSITIVE_INFINITY, 0);
    expected.put(task.id(), course.expectation());
    free(team, course, task);
  }

  /** Its robots are free where it was delivered, or charge first. */
  private void free(List<Slot> team, Course course, ForecastTask task) {
    double load =
        switch (task) {
          case ForecastTask.Begun begun -> begun.load();
          case ForecastTask.Queued queued -> queued.load();
        };
    for (Slot slot : team) {
      slot.at = course.end();
      slot.place = task.visits().getLast().place();
      Double battery = slot.battery;
      if (battery != null) {
        double used = Energy.joules(course.metres(), load / team.size()) / Energy.BATTERY_JOULES;
        slot.battery = Math.max(0, battery - used);
        chargeIfLow(slot, slot.battery);
      }
    }
  }

  private void chargeIfLow(Slot slot, double battery) {
    if (battery >= charging.below() || !Double.isFinite(slot.at)) {
      return;
    }
    Vec2 from = slot.place;
    charging.points().stream()
        .min(Comparator.comparingDouble(point -> metres(slot, from, point)))
        .ifPresent(
            point -> {
              slot.at +=
                  delay * metres(slot, from, point) / slot.robot.speed()
                      + charging.seconds(battery);
              slot.place = point;
              slot.battery = charging.until();
            });
  }

  private void serve(List<ForecastTask.Queued> queued) {
    List<ForecastTask.Queued> left = new ArrayList<>();
    for (ForecastTask.Queued task : queued) {
      if (task.unknown() == null) {
        left.add(task);
      } else {
        expected.put(task.id(), Expectation.none(task.unknown()));
      }
    }
    while (!left.isEmpty()) {
      Choice best = null;
      for (ForecastTask.Queued task : left) {
        Choice choice = isNext(task) ? choice(task) : null;
        if (choice != null && (best == null || choice.score() < best.score())) {
          best = choice;
        }
      }
      if (best == null) {
        left.forEach(task -> expected.putIfAbsent(task.id(), Expectation.none(whyNot(task))));
        return;
      }
      begin(best);
      left.remove(best.task());
    }
  }

  /** Whether what must be delivered before it has its time. */
  private boolean isNext(ForecastTask.Queued task) {
    return task.after().isEmpty() || Double.isFinite(readyAt(task));
  }

  /** When what must be delivered before it is; infinite where that cannot be said. */
  private double readyAt(ForecastTask.Queued task) {
    if (task.after().isEmpty()) {
      return 0;
    }
    Expectation before = expected.get(task.after().getAsLong());
    return before == null
        ? Double.POSITIVE_INFINITY
        : before.delivery().orElse(Double.POSITIVE_INFINITY);
  }

  private void begin(Choice choice) {
    ForecastTask.Queued task = choice.task();
    Slot leader = choice.team().getFirst();
    Vec2 start = task.visits().getFirst().place();
    Drive approach = travel.drive(leader.place, start, leader.robot.diameter());
    double begin = Math.max(leader.at, readyAt(task));
    double late = Math.max(0, choice.pickUp() - begin - delay * seconds(leader, approach));
    Course course =
        course(
            choice.team(),
            begin + (choice.team().size() > 1 ? late : 0),
            approach,
            task.visits(),
            true);
    expected.put(task.id(), course.expectation());
    free(choice.team(), course, task);
  }

  /** Who could be there first; null: nobody. */
  private @Nullable Choice choice(ForecastTask.Queued task) {
    double ready = readyAt(task);
    List<Slot> able =
        inOrder.stream().filter(s -> task.allows(s.robot.name()) && Double.isFinite(s.at)).toList();
    Slot first = null;
    double soonest = Double.POSITIVE_INFINITY;
    boolean isTooHeavy = true;
    for (Slot slot : able) {
      if (slot.robot.maxLoad() < task.load() - ROUNDING) {
        continue;
      }
      isTooHeavy = false;
      double there = arrival(slot, task, ready);
      if (there < soonest) {
        soonest = there;
        first = slot;
      }
    }
    if (first != null) {
      return choice(task, List.of(first), soonest);
    }
    return isTooHeavy && !task.isForOne() ? teamChoice(task, able, ready) : null;
  }

  private Choice choice(ForecastTask.Queued task, List<Slot> team, double pickUp) {
    double speed = team.getFirst().robot.speed();
    return new Choice(
        task, team, pickUp, pickUp - METRES_PER_SECOND_WAITED / speed * task.waited());
  }

  /** Those that are there first and strong enough together. */
  private @Nullable Choice teamChoice(ForecastTask.Queued task, List<Slot> able, double ready) {
    List<Slot> team = new ArrayList<>();
    double kilograms = 0;
    for (Slot slot :
        able.stream()
            .filter(s -> Double.isFinite(arrival(s, task, ready)))
            .sorted(Comparator.comparingDouble(s -> arrival(s, task, ready)))
            .toList()) {
      team.add(slot);
      kilograms += slot.robot.maxLoad();
      if (kilograms >= task.load() - ROUNDING) {
        return choice(task, team, arrival(slot, task, ready));
      }
    }
    return null;
  }

  /** When the robot could be where the task begins, by the length of its path; infinite: never. */
  private double arrival(Slot slot, ForecastTask.Queued task, double ready) {
    double metres = metres(slot, slot.place, task.visits().getFirst().place());
    return Math.max(slot.at, ready) + delay * metres / slot.robot.speed();
  }

  private double metres(Slot slot, Vec2 from, Vec2 to) {
    double diameter = slot.robot.diameter();
    return approaches
        .computeIfAbsent(new Approach(to, diameter), a -> travel.lengthsTo(a.place(), diameter))
        .applyAsDouble(from);
  }

  private Unknown whyNot(ForecastTask.Queued task) {
    if (!isNext(task)) {
      return Unknown.AFTER_UNKNOWN;
    }
    boolean isAnyAble =
        inOrder.stream()
            .anyMatch(
                s ->
                    task.allows(s.robot.name())
                        && s.robot.maxLoad() >= task.load() - ROUNDING
                        && Double.isFinite(s.at));
    return isAnyAble ? Unknown.NO_PATH : Unknown.NO_ROBOT;
  }

  /**
   * From visit to visit.
   *
   * @param begin seconds until the first drive begins
   * @param first the drive to the first visit
   * @param isPickUp whether the load is picked up there
   */
  private Course course(
      List<Slot> team, double begin, Drive first, List<Visit> visits, boolean isPickUp) {
    double at = begin;
    double metres = 0;
    OptionalDouble pickUp = OptionalDouble.empty();
    Vec2 place = visits.getFirst().place();
    for (int i = 0; i < visits.size(); i++) {
      Visit visit = visits.get(i);
      Drive drive =
          i == 0 ? first : travel.drive(place, visit.place(), team.getFirst().robot.diameter());
      place = visit.place();
      if (!drive.isPossible()) {
        return unknownFrom(pickUp, Unknown.NO_PATH);
      }
      metres += drive.metres();
      at += delay * slowestSeconds(team, drive) + visit.waitSeconds();
      if (Double.isInfinite(at)) {
        return unknownFrom(pickUp, Unknown.AWAITS_PERSON);
      }
      if (i == 0 && isPickUp) {
        pickUp = OptionalDouble.of(at);
      }
    }
    return new Course(new Expectation(pickUp, OptionalDouble.of(at), null), at, metres);
  }

  private static Course unknownFrom(OptionalDouble pickUp, Unknown why) {
    return new Course(
        new Expectation(pickUp, OptionalDouble.empty(), why), Double.POSITIVE_INFINITY, 0);
  }

  private static double slowestSeconds(List<Slot> team, Drive drive) {
    return team.stream().mapToDouble(slot -> seconds(slot, drive)).max().orElse(0);
  }

  private static double seconds(Slot slot, Drive drive) {
    return drive.seconds(slot.robot.speed(), slot.robot.turnRate());
  }
}
