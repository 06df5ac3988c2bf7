package org.toqa.endtoend;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.function.BiConsumer;
import org.toqa.endtoend.WorkLedger.Answer;
import org.toqa.testbed.ApiClient.Reply;
import tools.jackson.databind.JsonNode;

/** Carries a {@link CrashPlan} out at a site, and judges what has become of the work. */
final class CrashRun {
  private static final int LINES_OF_IMPORT = 10;

  /** The others of an import are cancelled. */
  private static final int CARRIED_OF_IMPORT = 1;

  private static final Duration DUE_IN = Duration.ofMillis(700);
  private static final Duration TIMEOUT = Duration.ofMinutes(10);

  /** From one look at the tasks to the next; bodies are looked at all the time. */
  private static final int LOOK_MILLIS = 250;

  /** Of 20 ms or less: who stands for so long does not only turn or wait for another one. */
  private static final long STEPS_OF_STANDING = 500;

  /** Of the server's log, where something has not ended. */
  private static final int LAST_LINES = 200;

  /** A task whose robots stand for so long while the server says no word why is stuck. */
  private static final Duration UNTIL_STUCK = Duration.ofSeconds(60);

  private final CrashTestbed site;
  private final CrashPlan plan;
  private final WorkLedger ledger = new WorkLedger(LINES_OF_IMPORT);
  private final Map<String, Long> counts = new HashMap<>();
  private final PublishedMaps maps;
  private int named;

  CrashRun(CrashTestbed site, CrashPlan plan) {
    this.site = site;
    this.plan = plan;
    this.maps = new PublishedMaps(site, 200 + 10L * (plan.seed() % 200));
  }

  /** What the server did, not merely was asked for, by the plural of its kind. */
  Map<String, Long> counts() {
    return counts;
  }

  private void count(Work.Kind kind) {
    counts.merge(kind.plural(), 1L, Long::sum);
  }

  void run() throws Exception {
    for (Work work : plan.first()) {
      perform(work);
    }
    String table = plan.prefix() + "imported.";
    CompletableFuture<Reply> imported = null;
    for (CrashPlan.Step step : plan.steps()) {
      CompletableFuture<Reply> published = null;
      Optional<ActiveHold> hold = Optional.empty();
      if (step.before().kind() == Work.Kind.PUBLICATION) {
        published = maps.publish();
      } else {
        hold = begin(step.before());
      }
      TimeUnit.MILLISECONDS.sleep(step.fault().delayMillis());
      if (imported == null) {
        imported =
            site.server
                .api()
                .replyToTable("tasks/import", plan.imported().table(table, LINES_OF_IMPORT), table);
        TimeUnit.MILLISECONDS.sleep(step.fault().millisIntoImport());
      }
      endure(step);
      if (published != null) {
        Answer told = answer(published, false);
        assertFalse(told == Answer.REFUSED, "a good map was refused");
        maps.add(told);
        count(Work.Kind.PUBLICATION);
      }
      if (hold.isPresent()) {
        if (!hold.get().isCancelled(ledger)) {
          hold.get().check();
        }
        hold.get().resume();
        count(step.before().kind());
      }
    }
    Answer answer = answer(imported);
    ledger.addImport(table, answer);
    if (answer == Answer.ACCEPTED) {
      count(Work.Kind.IMPORT);
    }
    cancelMostOf(table);
    awaitEnds();
    ledger.judge(kept(), scheduledTasks());
    maps.judge();
    site.truth().endRun();
  }

  /** The fault from its beginning to its end, with what people want meanwhile. */
  private void endure(CrashPlan.Step step) throws Exception {
    Fault fault = step.fault();
    fault.inject(site);
    FutureTask<Void> work =
        new FutureTask<>(
            () -> {
              perform(step.during());
              return null;
            });
    try {
      Thread.startVirtualThread(work); // nothing else is done by the ledger until it has ended
      // how long it is broken: nothing is waited for
      TimeUnit.MILLISECONDS.sleep(fault.durationMillis());
      if (fault.isUntilAnswered()) {
        await(work);
      }
    } finally {
      fault.clear(site);
    }
    await(work);
  }

  private static void await(FutureTask<Void> work) throws Exception {
    try {
      work.get(TIMEOUT.toSeconds(), TimeUnit.SECONDS);
    } catch (ExecutionException e) {
      switch (e.getCause()) {
        case Exception failure -> throw failure;
        case Error failure -> throw failure;
        case null, default -> throw e;
      }
    }
  }

  private Optional<ActiveHold> begin(Work work) throws Exception {
    if (!work.kind().isHold()) {
      perform(work);
      return Optional.empty();
    }
    site.awaitRobots();
    if (work.kind() != Work.Kind.TASK_HOLD) {
      return Optional.of(ActiveHold.of(site, work));
    }
    String name = name(work);
    long id = site.server.awaitAccepted("tasks", work.order(name)).get("id").asLong();
    ledger.addTask(name, id);
    List<String> until = List.of("QUEUED", "TO_OBJECT", "CARRYING").subList(work.number() % 3, 3);
    site.server.await("tasks/" + id, task -> until.contains(task.get("state").asString()));
    return Optional.of(ActiveHold.ofTask(site, id));
  }

  private void perform(Work work) throws Exception {
    switch (work.kind()) {
      case DELIVERY, TEAM_DELIVERY, IMPOSSIBLE_DELIVERY -> order(work);
      case CANCEL -> {
        if (!ledger.ids().isEmpty()) {
          cancel(ledger.ids().get(work.number() % ledger.ids().size()), work.number());
        }
      }
      case SCHEDULE -> {
        String name = name(work);
        ask(
            "schedules",
            Map.of("task", work.order(name), "at", Instant.now().plus(DUE_IN).toString()),
            (answer, schedule) -> {
              ledger.addSchedule(name, answer);
              if (answer == Answer.ACCEPTED) {
                count(work.kind());
              }
            });
      }
      case FAULTY_IMPORT -> {
        String beginning = name(work) + ".";
        Answer answer =
            answer(
                site.server
                    .api()
                    .replyToTable(
                        "tasks/import", work.table(beginning, LINES_OF_IMPORT), beginning));
        assertFalse(answer == Answer.ACCEPTED, "a faulty import was accepted");
        ledger.addImport(beginning, Answer.REFUSED);
        count(work.kind());
      }
      default -> throw new IllegalArgumentException("not without more: " + work);
    }
  }

  private void order(Work work) throws Exception {
    String name = name(work);
    ask(
        "tasks",
        work.order(name),
        (answer, task) -> {
          boolean isImpossible = work.kind() == Work.Kind.IMPOSSIBLE_DELIVERY;
          if (answer == Answer.ACCEPTED) {
            assertFalse(isImpossible, "into a wall");
            ledger.addTask(name, task.get("id").asLong());
            count(work.kind());
          } else {
            ledger.addTask(name, isImpossible ? Answer.REFUSED : answer);
            if (isImpossible && answer == Answer.REFUSED) {
              count(work.kind());
            }
          }
        });
  }

  private void cancel(long task, int number) throws Exception {
    ask(
        "tasks/" + task + "/cancel",
        Map.of("load", number % 2 == 0 ? "here" : "back"),
        (answer, cancelled) -> {
          ledger.addCancel(task, answer);
          if (answer == Answer.ACCEPTED) {
            count(Work.Kind.CANCEL);
          }
        });
  }

  /** Tells the answer, and what came with it. */
  private void ask(String path, Map<String, Object> body, BiConsumer<Answer, JsonNode> told)
      throws Exception {
    try {
      Reply reply = site.server.api().replyTo(path, body);
      told.accept(answer(reply, path.equals("tasks")), reply.body());
    } catch (IOException e) { // the server is dead
      told.accept(Answer.UNKNOWN, null);
    }
  }

  /**
   * @param isWithdrawn whether what is not taken in time is not taken later
   */
  private static Answer answer(Reply reply, boolean isWithdrawn) {
    assertTrue(reply.status() < 500 || reply.isUnavailable(), reply::toString);
    if (reply.isAccepted()) {
      return Answer.ACCEPTED;
    }
    return reply.isUnavailable() && !isWithdrawn ? Answer.UNKNOWN : Answer.REFUSED;
  }

  private static Answer answer(CompletableFuture<Reply> table) throws Exception {
    return answer(table, true);
  }

  private static Answer answer(CompletableFuture<Reply> reply, boolean isWithdrawn)
      throws Exception {
    try {
      return answer(reply.get(TIMEOUT.toSeconds(), TimeUnit.SECONDS), isWithdrawn);
    } catch (ExecutionException e) { // the server died
      return Answer.UNKNOWN;
    }
  }

  private String name(Work work) {
    return plan.prefix() + named++ + " " + work;
  }

  private void cancelMostOf(String table) throws Exception {
    List<JsonNode> there =
        tasks().stream().filter(task -> task.get("name").asString().startsWith(table)).toList();
    for (JsonNode task : there.subList(0, Math.max(0, there.size() - CARRIED_OF_IMPORT))) {
      cancel(task.get("id").asLong(), 0);
    }
  }

  /** The run's tasks, without their histories. */
  private List<JsonNode> tasks() throws Exception {
    return site.server
        .await("tasks?limit=500&text=" + plan.prefix(), tasks -> true)
        .valueStream()
        .toList();
  }

  private void awaitEnds() throws Exception {
    long end = System.nanoTime() + TIMEOUT.toNanos();
    Map<Long, Long> wordlessSince = new HashMap<>();
    while (true) {
      List<JsonNode> open = new ArrayList<>(tasks());
      carryLoadsAway(open);
      open.removeIf(task -> List.of("DONE", "CANCELLED").contains(task.get("state").asString()));
      if (open.isEmpty() && isNoneDue()) {
        return;
      }
      for (JsonNode task : open) {
        long id = task.get("id").asLong();
        if (isStandingWithoutReason(task)) {
          long since = wordlessSince.computeIfAbsent(id, first -> System.nanoTime());
          assertTrue(
              System.nanoTime() - since < UNTIL_STUCK.toNanos(), () -> "it says not why: " + task);
        } else {
          wordlessSince.remove(id);
        }
      }
      if (System.nanoTime() > end) {
        fail("these have not ended: " + open + whatIsGoingOn());
      }
      TimeUnit.MILLISECONDS.sleep(LOOK_MILLIS);
    }
  }

  private String whatIsGoingOn() throws Exception {
    return "\nrobots: "
        + site.server.api().tryToGet("robots")
        + "\nlast events: "
        + site.server.api().tryToGet("history?limit=60")
        + "\nits log: "
        + String.join("\n", site.server.lastLines(LAST_LINES));
  }

  private boolean isNoneDue() throws Exception {
    return schedules().stream()
        .filter(schedule -> ledger.isScheduled(scheduledTask(schedule)))
        .allMatch(schedule -> schedule.get("due").isNull());
  }

  /** As people would, so that what cancelled tasks left on the floor does not stop all others. */
  private void carryLoadsAway(List<JsonNode> tasks) throws Exception {
    for (JsonNode task : tasks) {
      if (task.get("state").asString().equals("CANCELLED") && !task.get("loadAt").isNull()) {
        site.server.api().replyTo("tasks/" + task.get("id").asLong() + "/load-removed", Map.of());
      }
    }
  }

  /** What ails the whole fleet, such as a database that is away, is said on every page. */
  private boolean isStandingWithoutReason(JsonNode task) throws Exception {
    List<String> robots = task.get("robots").valueStream().map(JsonNode::asString).toList();
    return task.get("waitingFor").isNull()
        && task.get("needs").isNull()
        && site.server.api().tryToGet("health").isPresent()
        && site.truth().haveStood(robots.isEmpty() ? site.robots() : robots, STEPS_OF_STANDING);
  }

  /** The run's tasks with their histories, which are read from the store, and may come later. */
  private List<JsonNode> kept() throws Exception {
    List<JsonNode> kept = new ArrayList<>();
    for (JsonNode task : tasks()) {
      boolean isDone = task.get("state").asString().equals("DONE");
      kept.add(
          site.server.await(
              "tasks/" + task.get("id").asLong(),
              t -> !isDone || WorkLedger.eventCount(t, "Done") > 0));
    }
    return kept;
  }

  private List<JsonNode> schedules() throws Exception {
    return site.server.await("schedules", schedules -> true).valueStream().toList();
  }

  private List<String> scheduledTasks() throws Exception {
    return schedules().stream().map(CrashRun::scheduledTask).toList();
  }

  private static String scheduledTask(JsonNode schedule) {
    return schedule.get("task").get("name").asString();
  }
}
