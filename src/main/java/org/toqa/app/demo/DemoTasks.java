package org.toqa.app.demo;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.app.command.StopSignal;
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
 * The tasks of the demo: submits them, reports their progress, and sums them up. They lead between
 * all sides of the shipped floor, so that the robots' paths cross.
 */
final class DemoTasks {
  private static final Duration POLL_PERIOD = Duration.ofMillis(250);

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
  private static final TaskOrder FORMATION_ORDER =
      order("Gearbox to packing", 12, "Goods-in 2", "Packing 2");

  /** One on each of the other floors. */
  private static final List<TaskOrder> ELSEWHERE =
      List.of(
          order("Post to the archive", 1, "Post room", "Archive", "offices"),
          order("Pallet to the lift", 4, "Rack 2", "Lift", "store"),
          order("Frame to the paint shop", 3, "Welding", "Paint shop", "workshop"));

  /** How many robots are on each of those floors. */
  static final String ROBOTS_ELSEWHERE = "2,2,1";

  /** More tasks than robots: some have to wait for a robot. */
  private static final int EXTRA_TASKS = 2;

  /** As many as the shipped floor has parking points. */
  static final int MAX_ROBOTS = 8;

  private final Fleet fleet;
  private final InstantSource clock;
  private final Map<Long, Progress> progressByTask = new LinkedHashMap<>();

  /** A task of the demo while it is carried out. */
  private static final class Progress {
    final Instant startedAt;
    TaskView task;
    double seconds;

    Progress(TaskView seen, Instant began) {
      this.task = seen;
      this.startedAt = began;
    }
  }

  DemoTasks(Fleet fleet, InstantSource clock) {
    this.fleet = fleet;
    this.clock = clock;
  }

  private static TaskOrder order(String name, double load, String start, String goal) {
    return order(name, load, start, goal, null);
  }

  static TaskOrder order(
      String name, double load, String start, String goal, @Nullable String floor) {
    return new TaskOrder(
        name, load, new Where.Station(start), new Where.Station(goal), floor, 0, null, null);
  }

  /**
   * The tasks for a number of robots: a few more than there are robots, and those of other floors.
   *
   * @param robots of the first floor, 1 to {@link #MAX_ROBOTS}
   */
  static List<TaskOrder> orders(int robots) {
    Stream<TaskOrder> together = robots < 3 ? Stream.empty() : Stream.of(FORMATION_ORDER);
    return Stream.concat(
            Stream.concat(together, ORDERS.stream()).limit(robots + EXTRA_TASKS),
            ELSEWHERE.stream())
        .toList();
  }

  /**
   * @param user as whom they are submitted
   * @throws IllegalStateException the fleet does not accept one; the message says why
   * @throws Exception the fleet did not answer within 30 s
   */
  void submit(List<TaskOrder> orders, String user) throws Exception {
    for (TaskOrder order : orders) {
      Answer<TaskView> answer =
          fleet.submit(order, user).toCompletableFuture().get(30, TimeUnit.SECONDS);
      switch (answer) {
        case Answer.Accepted<TaskView>(TaskView task) ->
            progressByTask.put(task.id(), new Progress(task, clock.instant()));
        case Answer.Rejected<TaskView>(String field, Sentence sentence) ->
            throw new IllegalStateException(order.name() + ": " + sentence);
        case Answer.Conflict<TaskView>(Sentence sentence, Question needs) ->
            throw new IllegalStateException(order.name() + ": " + sentence);
        case Answer.Outdated<TaskView>() -> throw new IllegalStateException(order.name());
        case Answer.Unknown<TaskView>(Sentence sentence) ->
            throw new IllegalStateException(order.name() + ": " + sentence);
      }
    }
  }

  /**
   * Reports every change until all tasks have ended, or the process is asked to stop.
   *
   * @param reporter gets a line for each change
   * @return whether all are done
   */
  boolean awaitEnd(StopSignal stop, Consumer<String> reporter) throws InterruptedException {
    long version = -1;
    while (!stop.isRequested()
        && progressByTask.values().stream().anyMatch(r -> !r.task.state().isEnded())) {
      FleetSnapshot snapshot = fleet.snapshots().awaitNewer(version, POLL_PERIOD);
      version = snapshot.version();
      snapshot.tasks().forEach(task -> reportChange(task, reporter));
    }
    return progressByTask.values().stream().allMatch(r -> r.task.state() == TaskState.DONE);
  }

  /**
   * Reports every change of all tasks, also of those that come meanwhile, until it is over or the
   * process is asked to stop.
   *
   * @param reporter gets a line for each change
   */
  void awaitEnd(StopSignal stop, Consumer<String> reporter, BooleanSupplier isOver)
      throws InterruptedException {
    long version = -1;
    while (!stop.isRequested() && !isOver.getAsBoolean()) {
      FleetSnapshot snapshot = fleet.snapshots().awaitNewer(version, POLL_PERIOD);
      version = snapshot.version();
      for (TaskView task : snapshot.tasks().reversed()) { // the oldest first
        progressByTask.computeIfAbsent(task.id(), _ -> new Progress(task, clock.instant()));
        reportChange(task, reporter);
      }
    }
  }

  private void reportChange(TaskView task, Consumer<String> reporter) {
    Progress progress = progressByTask.get(task.id());
    if (progress == null || progress.task.state() == task.state()) {
      return;
    }
    progress.task = task;
    progress.seconds = Duration.between(progress.startedAt, clock.instant()).toMillis() / 1000.0;
    reporter.accept(
        String.format(
            Locale.ROOT,
            "  %6.1f s  %-26s %s",
            progress.seconds,
            task.task().name(),
            stateSentence(task)));
  }

  private static String stateSentence(TaskView task) {
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

  /** Each task with its state, its robots and its seconds of simulated time. */
  String table() {
    StringBuilder table = new StringBuilder();
    String row = "  %-26s %-10s %-12s %8s%n";
    table.append(String.format(Locale.ROOT, row, "TASK", "STATE", "ROBOTS", "SECONDS"));
    for (Progress run : progressByTask.values()) {
      table.append(
          String.format(
              Locale.ROOT,
              row,
              run.task.task().name(),
              run.task.state(),
              String.join(" ", run.task.robots()),
              String.format(Locale.ROOT, "%.1f", run.seconds)));
    }
    return table.toString();
  }

  /** As {@code --report} writes it; seconds are of simulated time. */
  String json() {
    List<Map<String, Object>> tasks = new ArrayList<>();
    for (Progress run : progressByTask.values()) {
      Map<String, Object> task = new LinkedHashMap<>();
      task.put("name", run.task.task().name());
      task.put("floor", run.task.task().floor());
      task.put("state", run.task.state().name());
      task.put("robots", run.task.robots());
      task.put("seconds", run.seconds);
      tasks.add(task);
    }
    return JsonMapper.builder().build().writeValueAsString(Map.of("tasks", tasks)) + "\n";
  }
}
