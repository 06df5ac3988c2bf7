package org.toqa.fleet.supervision;

import java.time.Instant;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;

/**
 * A supervisor and its workers at work on a floor, as it is stored.
 *
 * @param run tells one from those that were begun before on that floor
 * @param supervisor the robot with cameras
 * @param workers the robots with arms
 * @param overlaps whether boxes are looked for and ordered while others are carried; otherwise only
 *     while no worker has any
 * @param user who began it; the tasks are his
 * @param idleSeconds how long workers had nothing to do while boxes were left, all together, of the
 *     fleet's time
 * @param boxes by number
 * @param seen what the supervisor has seen of the floor, as {@link SeenArea#text} has it
 */
public record Supervision(
    String floor,
    String run,
    String supervisor,
    List<String> workers,
    boolean overlaps,
    String user,
    State state,
    Instant begunAt,
    @Nullable Instant endedAt,
    double idleSeconds,
    Map<Integer, SupervisedBox> boxes,
    String seen) {

  /** How far it is. */
  public enum State {
    RUNNING,
    /** Every box lies at its target. */
    DONE,
    /** A person has stopped it. */
    STOPPED
  }

  public Supervision {
    workers = List.copyOf(workers);
    boxes = new TreeMap<>(boxes);
  }

  public boolean isRunning() {
    return state == State.RUNNING;
  }

  public long deliveredCount() {
    return boxes.values().stream().filter(SupervisedBox::delivered).count();
  }

  /** Seconds that workers had nothing to do, for each box that was delivered; empty: none was. */
  public Optional<Double> idleSecondsPerBox() {
    long delivered = deliveredCount();
    return delivered == 0 ? Optional.empty() : Optional.of(idleSeconds / delivered);
  }

  boolean isAllDelivered() {
    return deliveredCount() == boxes.size();
  }

  Supervision with(SupervisedBox box) {
    Map<Integer, SupervisedBox> changed = new TreeMap<>(boxes);
    changed.put(box.number(), box);
    return withBoxes(changed.values());
  }

  Supervision without(int number) {
    Map<Integer, SupervisedBox> left = new TreeMap<>(boxes);
    left.remove(number);
    return withBoxes(left.values());
  }

  Supervision withBoxes(Collection<SupervisedBox> changed) {
    Map<Integer, SupervisedBox> byNumber = new TreeMap<>();
    changed.forEach(box -> byNumber.put(box.number(), box));
    return new Supervision(
        floor,
        run,
        supervisor,
        workers,
        overlaps,
        user,
        state,
        begunAt,
        endedAt,
        idleSeconds,
        byNumber,
        seen);
  }

  Supervision withSeen(String area) {
    return new Supervision(
        floor,
        run,
        supervisor,
        workers,
        overlaps,
        user,
        state,
        begunAt,
        endedAt,
        idleSeconds,
        boxes,
        area);
  }

  Supervision withIdle(double seconds) {
    return new Supervision(
        floor,
        run,
        supervisor,
        workers,
        overlaps,
        user,
        state,
        begunAt,
        endedAt,
        seconds,
        boxes,
        seen);
  }

  Supervision ended(State how, Instant at) {
    return new Supervision(
        floor,
        run,
        supervisor,
        workers,
        overlaps,
        user,
        how,
        begunAt,
        at,
        idleSeconds,
        boxes,
        seen);
  }
}
