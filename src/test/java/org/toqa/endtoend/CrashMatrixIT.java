package org.toqa.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.testbed.Tally;
import tools.jackson.databind.JsonNode;

/**
 * Server, daemons, database and links are cut at random moments while robots carry. Every task that
 * was accepted ends DONE once, and what was refused is never done.
 *
 * <p>{@code -Dtoqa.crashes=200} for so many runs, {@code -Dtoqa.seed=17} to begin with another
 * seed.
 */
@Tag("full")
class CrashMatrixIT {
  private static final int RUNS = Integer.getInteger("toqa.crashes", 8);
  private static final int FROM = Integer.getInteger("toqa.seed", 1);
  private static final List<String> STATIONS =
      List.of("Goods-in 1", "Mill", "Store A", "Assembly", "Packing 1", "Goods-out");
  private static final Pattern DELIVERY = Pattern.compile("task (\\d+): phase 2 is done");

  /**
   * As long as batteries last. The robots have nothing but their odometry, and after an hour they
   * would miss a charger.
   */
  private static final int RUNS_OF_A_SITE = 8;

  @TempDir private static Path folder;
  private static CrashTestbed testbed;
  private static int runs;

  @BeforeAll
  static void build() throws Exception {
    testbed = newTestbed(FROM);
  }

  @AfterAll
  static void clear() throws Exception {
    Tally.add("runs with crashes", runs);
    testbed.close();
  }

  @TestFactory
  Stream<DynamicTest> nothingIsLostAndNothingDoneTwice() {
    return IntStream.iterate(FROM, first -> first < FROM + RUNS, first -> first + RUNS_OF_A_SITE)
        .boxed()
        .flatMap(first -> atOneSite(first, Math.min(first + RUNS_OF_A_SITE, FROM + RUNS)));
  }

  private Stream<DynamicTest> atOneSite(int first, int end) {
    Stream<DynamicTest> runs =
        IntStream.range(first, end)
            .mapToObj(
                seed -> {
                  Random random = new Random(seed);
                  List<Fault> cuts = Fault.random(random);
                  return DynamicTest.dynamicTest(
                      "seed " + seed + ": " + cuts, () -> run(seed, cuts, random));
                });
    DynamicTest words = DynamicTest.dynamicTest("what the robots say", this::robotsDeliveredOnce);
    return first == FROM
        ? Stream.concat(runs, Stream.of(words))
        : Stream.of(
                Stream.of(DynamicTest.dynamicTest("the next site", () -> replaceTestbed(first))),
                runs,
                Stream.of(words))
            .flatMap(tests -> tests);
  }

  private static CrashTestbed newTestbed(int seed) throws Exception {
    return new CrashTestbed(Files.createDirectory(folder.resolve("from-" + seed)));
  }

  private static void replaceTestbed(int seed) throws Exception {
    testbed.close();
    testbed = newTestbed(seed);
  }

  private void run(int seed, List<Fault> cuts, Random random) throws Exception {
    List<Long> accepted = new ArrayList<>();
    List<String> refused = new ArrayList<>();
    for (int i = 0; i < 2; i++) {
      submitTask("run " + seed + " task " + i, random, accepted, refused);
    }
    for (Fault cut : cuts) {
      TimeUnit.MILLISECONDS.sleep(cut.delayMillis());
      cut.inject(testbed);
      try {
        submitTask("run " + seed + " while " + cut.kind(), random, accepted, refused);
        TimeUnit.MILLISECONDS.sleep(cut.durationMillis());
      } finally {
        cut.clear(testbed);
      }
    }
    assertTrue(!accepted.isEmpty(), "no task was accepted");
    for (long task : accepted) {
      testbed.server.await("tasks/" + task, CrashMatrixIT::isStoredAsDone);
      assertEquals(1, testbed.server.eventCount(task, "Picked up"), () -> taskHistory(task));
      assertEquals(1, testbed.server.eventCount(task, "Delivered"), () -> taskHistory(task));
      assertEquals(1, testbed.server.eventCount(task, "Created by"), () -> taskHistory(task));
      assertEquals(1, testbed.server.eventCount(task, "Done"), () -> taskHistory(task));
    }
    for (JsonNode task : testbed.server.api().get("tasks?limit=10")) {
      assertTrue(
          !refused.contains(task.get("name").asString()), () -> "refused, but kept: " + task);
    }
    runs++;
  }

  /** What the live task says may be ahead of its history, which is read from the store. */
  private static boolean isStoredAsDone(JsonNode task) {
    JsonNode history = task.get("history");
    return task.get("state").asString().equals("DONE")
        && history.get(history.size() - 1).get("text").asString().equals("Done");
  }

  /** Adds a task to those that must be done or to those that must not; unknown ones to neither. */
  private void submitTask(String name, Random random, List<Long> accepted, List<String> refused)
      throws InterruptedException {
    int start = random.nextInt(STATIONS.size());
    int goal = (start + 1 + random.nextInt(STATIONS.size() - 1)) % STATIONS.size();
    try {
      Optional<JsonNode> answer =
          testbed
              .server
              .api()
              .tryToPost(
                  "tasks", RunningServer.order(name, STATIONS.get(start), STATIONS.get(goal)));
      answer.ifPresentOrElse(
          task -> accepted.add(task.get("id").asLong()), () -> refused.add(name));
    } catch (IOException e) {
      // the server is dead; whether it took the task nobody knows
    }
  }

  private void robotsDeliveredOnce() throws Exception {
    Map<Long, Integer> deliveries = new HashMap<>();
    for (String line : testbed.errorOutput()) {
      Matcher delivery = DELIVERY.matcher(line);
      if (delivery.find()) {
        deliveries.merge(Long.valueOf(delivery.group(1)), 1, Integer::sum);
      }
    }
    assertTrue(!deliveries.isEmpty());
    deliveries.values().removeIf(times -> times == 1);
    assertEquals(Map.of(), deliveries);
  }

  private String taskHistory(long task) {
    try {
      return testbed.server.task(task).toPrettyString();
    } catch (Exception e) {
      return e.toString();
    }
  }
}
