package org.toqa.fleet;

import java.time.Duration;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.Objects;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;
import org.toqa.mission.ArmHandling;
import org.toqa.mission.Stop;
import org.toqa.mission.TaskKind;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TransportTask;
import org.toqa.mission.TransportTask.LoadSize;

/**
 * An order for a transport task, as a form or the API brings it. The fleet checks it against the
 * floor and the robots; the web has checked only its shape.
 *
 * @param load kilograms; 0: a drive without a load, which has stops, one or more
 * @param floor null: the one of {@link FloorChoice}
 * @param onlyRobots names of those that may carry it; empty: whichever there are
 * @param arm null: no arm picks it up
 * @param stops all of its way, the start first and the goal last; empty: from start to goal, and
 *     nobody waits
 */
public record TaskOrder(
    String name,
    double load,
    Where start,
    Where goal,
    @Nullable String floor,
    int priority,
    @Nullable Instant deadline,
    @Nullable LoadSize size,
    List<String> onlyRobots,
    List<StopOrder> stops,
    @Nullable ArmHandling arm) {

  /**
   * A place on its way, and what robots wait for there: as {@link Stop}.
   *
   * @param until as far as the robot charges there, of 0 to 1; null: nobody said
   */
  public record StopOrder(
      Where where, boolean awaitsPerson, @Nullable Duration waitTime, @Nullable Double until) {

    /** One at which no robot charges. */
    public StopOrder(Where where, boolean awaitsPerson, @Nullable Duration waitTime) {
      this(where, awaitsPerson, waitTime, null);
    }

    /** Whether one robot must go all the way. */
    public boolean hasWait() {
      return awaitsPerson || waitTime != null || isCharging();
    }

    public boolean isCharging() {
      return where instanceof Where.Charger;
    }

    private Stop at(TaskPlace place) {
      return new Stop(place, awaitsPerson, waitTime, charge());
    }

    /** How the robot charges there; null: it does not. */
    public Stop.@Nullable Charge charge() {
      return where instanceof Where.Charger(String charger)
          ? new Stop.Charge(charger, until)
          : null;
    }

    private boolean isAt(Stop stop) {
      return where.isAt(stop.place())
          && Objects.equals(charge(), stop.charge())
          && awaitsPerson == stop.awaitsPerson()
          && Objects.equals(waitTime, stop.waitTime());
    }
  }

  /** As many stops a task may have, with start and goal. */
  public static final int MAX_STOPS = 20;

  /** As many names a task may have. */
  public static final int MAX_ONLY_ROBOTS = 20;

  public TaskOrder {
    onlyRobots = List.copyOf(onlyRobots);
    stops = List.copyOf(stops);
  }

  /** One whose load is put onto the robot and taken from it. */
  public TaskOrder(
      String name,
      double load,
      Where start,
      Where goal,
      @Nullable String floor,
      int priority,
      @Nullable Instant deadline,
      @Nullable LoadSize size,
      List<String> onlyRobots,
      List<StopOrder> stops) {
    this(name, load, start, goal, floor, priority, deadline, size, onlyRobots, stops, null);
  }

  /** One that any robot may carry. */
  public TaskOrder(
      String name,
      double load,
      Where start,
      Where goal,
      @Nullable String floor,
      int priority,
      @Nullable Instant deadline,
      @Nullable LoadSize size) {
    this(name, load, start, goal, floor, priority, deadline, size, List.of(), List.of());
  }

  /**
   * The task that is ordered; its id is not known yet.
   *
   * @param places what those of its way are on that floor
   */
  public TransportTask task(
      List<TaskPlace> places, String resolvedFloor, String user, Instant now) {
    TaskPlace from = places.getFirst();
    TaskPlace to = places.getLast();
    return new TransportTask(
            0, name, load, from, to, resolvedFloor, priority, deadline, size, user, now)
        .withOnlyRobots(onlyRobots)
        .withStops(
            IntStream.range(0, stops.size()).mapToObj(i -> stops.get(i).at(places.get(i))).toList())
        .withArm(arm);
  }

  /** The same from there to there. */
  public TaskOrder between(Where from, Where to) {
    return new TaskOrder(
        name, load, from, to, floor, priority, deadline, size, onlyRobots, List.of(), arm);
  }

  /**
   * The same along these stops.
   *
   * @param way at least two; of a drive at least one
   */
  public TaskOrder along(List<StopOrder> way) {
    return new TaskOrder(
        name,
        load,
        way.getFirst().where(),
        way.getLast().where(),
        floor,
        priority,
        deadline,
        size,
        onlyRobots,
        way,
        arm);
  }

  /** Whether nothing is carried. */
  public boolean isDrive() {
    return load == 0;
  }

  public TaskKind kind() {
    return isDrive() ? TaskKind.DRIVE : TaskKind.TRANSPORT;
  }

  /** All places of its way, the start first and the goal last. */
  public List<Where> places() {
    return stops.isEmpty() ? List.of(start, goal) : stops.stream().map(StopOrder::where).toList();
  }

  /** A place by its coordinates or by its station's name. */
  public sealed interface Where {
    record Point(Vec2 position) implements Where {}

    record Station(String name) implements Where {}

    /**
     * A charging point, at a stop alone.
     *
     * @param name null: the robot chooses one
     */
    record Charger(@Nullable String name) implements Where {}

    private boolean isAt(TaskPlace place) {
      return switch (this) {
        case Station(String name) -> name.equals(place.station());
        case Point(Vec2 position) -> place.station() == null && position.equals(place.position());
        case Charger _ -> true; // the stop says which
      };
    }
  }

  /** Whether the task is what this orders, but for the priority, which may have changed since. */
  public boolean isOrderOf(TransportTask task) {
    return name.equals(task.name())
        && load == task.load()
        && start.isAt(task.start())
        && goal.isAt(task.goal())
        && (floor == null || floor.equals(task.floor()))
        && Objects.equals(asStored(deadline), asStored(task.deadline()))
        && Objects.equals(size, task.size())
        && Objects.equals(arm, task.arm())
        && onlyRobots.equals(task.onlyRobots())
        && stops.size() == task.stops().size()
        && IntStream.range(0, stops.size()).allMatch(i -> stops.get(i).isAt(task.stops().get(i)));
  }

  /** As far as the store keeps it. */
  private static @Nullable Instant asStored(@Nullable Instant moment) {
    return moment == null ? null : moment.truncatedTo(ChronoUnit.MILLIS);
  }
}
