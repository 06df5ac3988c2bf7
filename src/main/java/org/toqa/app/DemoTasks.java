package org.toqa.app;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.toqa.fleet.Answer;
import org.toqa.fleet.Fleet;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.fleet.TaskView;
import org.toqa.mission.Question;
import org.toqa.mission.TaskState;
import org.toqa.wording.Sentence;
import tools.jackson.databind.json.JsonMapper;

/**
 * The tasks of the demo: puts them in, tells how they get on, and sums them up. They go to and fro
 * between all sides of the shipped floor, so that the robots' ways cross.
 */
final class DemoTasks {
  private static final Duration LOOK_EVERY = Duration.ofMillis(250);

  private static final List<TaskOrder> ORDERS =
      List.of(
          order("Steel to the mill", 4, "Goods-in 1", "Mill"),
          order("Parts to assembly", 2.5, "Store A", "Assembly"),
          order("Finished unit to packing", 3, "Assembly", "Packing 1"),
          order("Parcel to goods-out", 1.5, "Packing 2", "Goods-out"),
          order("Tools back to the store", 2, "Workbench 1", "Store C"),
          order("Castings to the test bench", 3.5, "Goods-in 2", "Test bench"),
          order("Bar stock to the store", 5, "Goods-in 1", "Store B"),
          order("Tested unit to packing", 3, "Test bench", "Packing 2"),
          order("Turned parts to goods-out", 2, "Mill", "Goods-out"),
          order("Spare parts to packing", 1, "Store C", "Packing 1"));

  /** First, while every battery lasts for it. */
  private static final TaskOrder FOR_THREE_ROBOTS =
      order("Gearbox to packing", 12, "Goods-in 2", "Packing 2");

  /** More tasks than robots: some have to wait for a robot. */
  private static final int QUEUED_AT_FIRST = 2;

  /** As many as the shipped floor has parking points. */
  static final int MOST_ROBOTS = 8;

  private final Fleet fleet;
  private final InstantSource time;
  private final Map<Long, Run> runs = new LinkedHashMap<>();

  /** A task of the demo while it is carried out. */
  private static final class Run {
    final Instant began;
    TaskView seen;
    double seconds;

    Run(TaskView seen, Instant began) {
      this.seen = seen;
      this.began = began;
    }
  }

  DemoTasks(Fleet fleet, InstantSource time) {
    this.fleet = fleet;
    this.time = time;
  }

  private static TaskOrder order(String name, double load, String start, String goal) {
    return new TaskOrder(
        name, load, new Where.Station(start), new Where.Station(goal), null, 0, null, null);
  }

  /**
   * What there is to do for so many robots.
   *
   * @param robots 1 to {@link #MOST_ROBOTS}
   */
  static List<TaskOrder> orders(int robots) {
    Stream<TaskOrder> together = robots < 3 ? Stream.empty() : Stream.of(FOR_THREE_ROBOTS);
    return Stream.concat(together, ORDERS.stream()).limit(robots + QUEUED_AT_FIRST).toList();
  }

  void submit(List<TaskOrder> orders, String user) throws Exception {
    for (TaskOrder order : orders) {
      Answer<TaskView> answer =
          fleet.submit(order, user).toCompletableFuture().get(30, TimeUnit.SECONDS);
      switch (answer) {
        case Answer.Accepted<TaskView>(TaskView task) ->
            runs.put(task.id(), new Run(task, time.instant()));
        case Answer.Refused<TaskView>(String field, Sentence sentence) ->
            throw new IllegalStateException(order.name() + ": " + sentence);
        case Answer.Conflict<TaskView>(Sentence sentence, Question needs) ->
            throw new IllegalStateException(order.name() + ": " + sentence);
        case Answer.Unknown<TaskView>(Sentence sentence) ->
            throw new IllegalStateException(order.name() + ": " + sentence);
      }
    }
  }

  /**
   * Tells of every change until all tasks have ended.
   *
   * @return whether all are done
   */
  boolean untilEnded(StopSignal stop, Consumer<String> teller) throws InterruptedException {
    long version = -1;
    while (!stop.isWished() && runs.values().stream().anyMatch(r -> !r.seen.state().isEnded())) {
      FleetSnapshot snapshot = fleet.feed().awaitNewer(version, LOOK_EVERY);
      version = snapshot.version();
      snapshot.tasks().forEach(task -> look(task, teller));
    }
    return runs.values().stream().allMatch(r -> r.seen.state() == TaskState.DONE);
  }

  private void look(TaskView task, Consumer<String> teller) {
    Run run = runs.get(task.id());
    if (run == null || run.seen.state() == task.state()) {
      return;
    }
    run.seen = task;
    run.seconds = Duration.between(run.began, time.instant()).toMillis() / 1000.0;
    teller.accept(
        String.format(
            Locale.ROOT, "  %6.1f s  %-26s %s", run.seconds, task.task().name(), sentence(task)));
  }

  private static String sentence(TaskView task) {
    String robots = String.join(", ", task.robots());
    String drive = task.robots().size() == 1 ? " drives" : " drive";
    String carry = task.robots().size() == 1 ? " carries it to " : " carry it together to ";
    return switch (task.state()) {
      case QUEUED -> "waits for a robot";
      case ASSIGNED -> "is given to " + robots;
      case TO_OBJECT -> robots + drive + " to " + task.task().start().text();
      case CARRYING -> robots + carry + task.task().goal().text();
      case RETURNING -> "is delivered, " + robots + drive + " home";
      case DONE -> "is done";
      case FAILED -> "failed";
      case CANCELLED -> "was cancelled";
    };
  }

  String table() {
    StringBuilder table = new StringBuilder();
    String row = "  %-26s %-10s %-12s %8s%n";
    table.append(String.format(Locale.ROOT, row, "TASK", "STATE", "ROBOTS", "SECONDS"));
    for (Run run : runs.values()) {
      table.append(
          String.format(
              Locale.ROOT,
              row,
              run.seen.task().name(),
              run.seen.state(),
              String.join(" ", run.seen.robots()),
              String.format(Locale.ROOT, "%.1f", run.seconds)));
    }
    return table.toString();
  }

  /** As {@code --report} writes it. */
  String json() {
    List<Map<String, Object>> tasks = new ArrayList<>();
    for (Run run : runs.values()) {
      Map<String, Object> task = new LinkedHashMap<>();
      task.put("name", run.seen.task().name());
      task.put("state", run.seen.state().name());
      task.put("robots", run.seen.robots());
      task.put("seconds", run.seconds);
      tasks.add(task);
    }
    return JsonMapper.builder().build().writeValueAsString(Map.of("tasks", tasks)) + "\n";
  }
}
