package org.toqa.mission;

import java.time.Instant;
import java.util.List;
import java.util.Objects;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;

/**
 * What was asked for: carry this load from here to there, or drive somewhere without one.
 *
 * @param load kilograms; 0: a drive without a load, which has stops, one or more
 * @param priority higher is served first; 0 is usual
 * @param deadline when it should be delivered, if anybody said so
 * @param size of the load, if anybody said so
 * @param user who asked, by his name then; the one it was handed over to, since
 * @param owner the id of his account, for names come back and ids do not; null: he is no user any
 *     more, or the task is not stored yet
 * @param part which part of an order it is; null: it was ordered by itself
 * @param onlyRobots names of those that may carry it; empty: whichever there are
 * @param arm null: the load is put onto the robot and taken from it
 * @param stops all of its way, the start first and the goal last; empty: from start to goal, and
 *     nobody waits. A drive's start is the first place to which it leads
 */
public record TransportTask(
    long id,
    String name,
    double load,
    TaskPlace start,
    TaskPlace goal,
    String floor,
    int priority,
    @Nullable Instant deadline,
    @Nullable LoadSize size,
    String user,
    @Nullable Long owner,
    Instant createdAt,
    @Nullable OrderPart part,
    List<String> onlyRobots,
    List<Stop> stops,
    @Nullable ArmHandling arm) {

  public TransportTask {
    onlyRobots = List.copyOf(onlyRobots);
    stops = List.copyOf(stops);
  }

  /** Kilograms and metres; what differs by less is what was entered twice. */
  private static final double ALIKE = 0.001;

  /**
   * Of the load's outline from above.
   *
   * @param length metres, along the load's x axis
   * @param width metres, along its y axis
   */
  public record LoadSize(double length, double width) {

    /** What is taken for a load whose size nobody said. */
    public static final LoadSize DEFAULT = new LoadSize(0.3, 0.3);

    /** Across the disc round it, metres: what it needs wherever it turns. */
    public double diameter() {
      return Math.hypot(length, width);
    }
  }

  /**
   * One whose owner is not known yet, that is no part of an order, and that any robot may carry.
   */
  public TransportTask(
      long id,
      String name,
      double load,
      TaskPlace start,
      TaskPlace goal,
      String floor,
      int priority,
      @Nullable Instant deadline,
      @Nullable LoadSize size,
      String user,
      Instant createdAt) {
    this(
        id, name, load, start, goal, floor, priority, deadline, size, user, null, createdAt, null,
        List.of(), List.of(), null);
  }

  private TransportTask copy(
      long newId,
      TaskPlace newStart,
      TaskPlace newGoal,
      String newUser,
      @Nullable Long newOwner,
      @Nullable OrderPart newPart,
      List<String> robots,
      List<Stop> way,
      @Nullable ArmHandling handling) {
    return new TransportTask(
        newId, name, load, newStart, newGoal, floor, priority, deadline, size, newUser, newOwner,
        createdAt, newPart, robots, way, handling);
  }

  /** The same with the id that the store gave it. */
  public TransportTask withId(long stored) {
    return copy(stored, start, goal, user, owner, part, onlyRobots, stops, arm);
  }

  /** The same, of that user. */
  public TransportTask withOwner(String newUser, @Nullable Long newOwner) {
    return copy(id, start, goal, newUser, newOwner, part, onlyRobots, stops, arm);
  }

  /** The same, that only these robots may carry; empty: whichever there are. */
  public TransportTask withOnlyRobots(List<String> robots) {
    return copy(id, start, goal, user, owner, part, robots, stops, arm);
  }

  /**
   * The same along these stops.
   *
   * @param way the start first and the goal last; empty: from start to goal
   */
  public TransportTask withStops(List<Stop> way) {
    return copy(id, start, goal, user, owner, part, onlyRobots, way, arm);
  }

  /** Whether nothing is carried: its robot drives from stop to stop, and that is all. */
  public boolean isDrive() {
    return load == 0;
  }

  public TaskKind kind() {
    return isDrive() ? TaskKind.DRIVE : TaskKind.TRANSPORT;
  }

  /**
   * Where its robots go first to get on with it.
   *
   * @param progress how far it has come
   */
  public TaskPlace firstPlace(StopProgress progress) {
    return isDrive() ? route().get(progress.stop()).place() : start;
  }

  /**
   * The number, from 0, of the stop that follows the place to which its robots go first; of a drive
   * that is at its last one there is none.
   */
  public int stopAfterFirst(StopProgress progress) {
    return isDrive() ? progress.stop() + 1 : Math.max(1, progress.stop());
  }

  /** Whether its robot charges at one of its stops. */
  public boolean hasCharging() {
    return stops.stream().anyMatch(stop -> stop.charge() != null);
  }

  /** All of its way, the start first and the goal last. */
  public List<Stop> route() {
    return stops.isEmpty() ? List.of(Stop.at(start), Stop.at(goal)) : stops;
  }

  /**
   * The places of its way from one on.
   *
   * @param stop from 0
   */
  public List<TaskPlace> placesFrom(int stop) {
    return route().stream().skip(stop).map(Stop::place).toList();
  }

  /** What it carries from each stop to the next one, as if that were all; a drive to one: none. */
  public List<TransportTask> legs() {
    List<TaskPlace> places = placesFrom(0);
    return IntStream.range(1, places.size())
        .mapToObj(i -> between(places.get(i - 1), places.get(i)))
        .toList();
  }

  private TransportTask between(TaskPlace from, TaskPlace to) {
    return copy(id, from, to, user, owner, part, onlyRobots, List.of(), arm);
  }

  /** The same with that handling of its load. */
  public TransportTask withArm(@Nullable ArmHandling handling) {
    return copy(id, start, goal, user, owner, part, onlyRobots, stops, handling);
  }

  /** The same as that part of an order. */
  public TransportTask withPart(@Nullable OrderPart changed) {
    return copy(id, start, goal, user, owner, changed, onlyRobots, stops, arm);
  }

  /** Whether the robot may carry it, alone or with others. */
  public boolean allows(String robot) {
    return onlyRobots.isEmpty() || onlyRobots.contains(robot);
  }

  /** Whether both carry the same load from the same place to the same one. */
  boolean hasSameTransport(TransportTask other) {
    return load == other.load
        && Objects.equals(size, other.size)
        && floor.equals(other.floor)
        && start.equals(other.start)
        && goal.equals(other.goal)
        && stops.equals(other.stops)
        && Objects.equals(arm, other.arm);
  }

  /** Whether its load is of that weight, kilograms, and size: the same one, as far as is known. */
  public boolean hasLoadOf(double weight, @Nullable LoadSize outline) {
    return Math.abs(load - weight) < ALIKE
        && (size == null
            ? outline == null
            : outline != null
                && Math.abs(size.length() - outline.length()) < ALIKE
                && Math.abs(size.width() - outline.width()) < ALIKE);
  }

  /** Whether the same is ordered of both, whoever did it and when. */
  public boolean isOrderedAs(TransportTask other) {
    return withOrder(other).equals(this);
  }

  /** The same task, of which that is ordered. */
  TransportTask withOrder(TransportTask order) {
    return new TransportTask(
        id,
        order.name,
        order.load,
        order.start,
        order.goal,
        order.floor,
        order.priority,
        order.deadline,
        order.size,
        user,
        owner,
        createdAt,
        part,
        order.onlyRobots,
        order.stops,
        order.arm);
  }

  TransportTask withPriority(int changed) {
    return new TransportTask(
        id,
        name,
        load,
        start,
        goal,
        floor,
        changed,
        deadline,
        size,
        user,
        owner,
        createdAt,
        part,
        onlyRobots,
        stops,
        arm);
  }
}
