package org.toqa.fleet;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.TreeMap;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;
import org.toqa.mission.OrderPart;
import org.toqa.mission.Question;
import org.toqa.mission.TaskState;
import org.toqa.wording.Sentence;

/**
 * An order that is carried as several tasks, as readers see it.
 *
 * @param parts how many were ordered
 * @param tasks all that are stored, by position and then in the order in which they came: a part
 *     that was ordered again has several
 */
public record OrderView(
    long id, String name, OrderPart.Kind kind, int parts, Instant createdAt, List<TaskView> tasks) {

  public OrderView {
    tasks = List.copyOf(tasks);
  }

  /** A part that does not go on by itself, and why. */
  public record StuckPart(TaskView task, Sentence why) {}

  /** The same with its tasks changed one by one. */
  public OrderView withTasks(UnaryOperator<TaskView> change) {
    return new OrderView(id, name, kind, parts, createdAt, tasks.stream().map(change).toList());
  }

  /** Of each part the newest task, in their order. */
  public List<TaskView> current() {
    TreeMap<Integer, TaskView> byPosition = new TreeMap<>();
    tasks.forEach(task -> byPosition.put(position(task), task));
    return List.copyOf(byPosition.values());
  }

  /** How many parts are at their goals. */
  public int delivered() {
    return (int) current().stream().filter(task -> task.state().isDelivered()).count();
  }

  /** What is still to be carried. */
  public List<TaskView> open() {
    return current().stream().filter(task -> isOpen(task.state())).toList();
  }

  /** How many of these a person has put on hold. */
  public int held() {
    return (int) open().stream().filter(TaskView::held).count();
  }

  /** The priority that all of these have; empty: they differ, or there is none. */
  public OptionalInt priority() {
    int[] priorities =
        open().stream().mapToInt(task -> task.task().priority()).distinct().limit(2).toArray();
    return priorities.length == 1 ? OptionalInt.of(priorities[0]) : OptionalInt.empty();
  }

  /** What ended without delivery. */
  public List<TaskView> undelivered() {
    return current().stream()
        .filter(task -> task.state().isEnded() && !task.state().isDelivered())
        .toList();
  }

  private static boolean isOpen(TaskState state) {
    return !state.isEnded() && !state.isDelivered();
  }

  public List<StuckPart> stuck() {
    return open().stream()
        .flatMap(task -> whyStuck(task).map(why -> new StuckPart(task, why)).stream())
        .toList();
  }

  private Optional<Sentence> whyStuck(TaskView task) {
    Question needs = task.needs();
    if (needs != null) {
      return Optional.of(needs.question());
    }
    Optional<Sentence> stopped = whyStopped(task);
    return stopped.isPresent() || !task.blocked()
        ? stopped
        : Optional.ofNullable(task.waitingFor());
  }

  /** Whether it is a leg that never begins by itself. */
  public boolean isStopped(TaskView task) {
    return task.state() == TaskState.QUEUED && whyStopped(task).isPresent();
  }

  private Optional<Sentence> whyStopped(TaskView task) {
    OrderPart part = task.task().part();
    if (part == null || !part.awaitsPrevious()) {
      return Optional.empty();
    }
    OrderPart.Previous previous = previous(part);
    return part.isStoppedBy(previous) ? part.reasonToWait(previous) : Optional.empty();
  }

  /** The task of the part before; null: there is none any more. */
  OrderPart.@Nullable Previous previous(OrderPart part) {
    return current().stream()
        .filter(task -> position(task) == part.position() - 1)
        .findFirst()
        .map(task -> new OrderPart.Previous(task.id(), task.state()))
        .orElse(null);
  }

  public OrderState state() {
    List<TaskView> open = open();
    if (open.isEmpty()) {
      boolean isUnderWay = current().stream().anyMatch(task -> !task.state().isEnded());
      boolean isAllDelivered = undelivered().isEmpty();
      return isUnderWay && isAllDelivered
          ? OrderState.IN_PROGRESS
          : isAllDelivered ? OrderState.DONE : OrderState.CANCELLED;
    }
    List<StuckPart> stuck = stuck();
    boolean goesOn = kind == OrderPart.Kind.PIECES ? stuck.size() < open.size() : stuck.isEmpty();
    if (!goesOn) {
      return OrderState.STOPPED;
    }
    boolean hasBegun =
        delivered() > 0 || open.stream().anyMatch(task -> task.state() != TaskState.QUEUED);
    return hasBegun ? OrderState.IN_PROGRESS : OrderState.QUEUED;
  }

  private static int position(TaskView task) {
    OrderPart part = task.task().part();
    return part == null ? 0 : part.position();
  }
}
