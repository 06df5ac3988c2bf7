package org.toqa.road;

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
import tools.jackson.databind.JsonNode;

/**
 * Server, daemons, database and links are cut at random moments while robots carry. Every task that
 * was accepted ends DONE once, and what was refused is never done.
 *
 * <p>{@code -Dtoqa.crashes=200} for so many runs, {@code -Dtoqa.crashes.from=17} to begin with
 * another seed.
 */
@Tag("full")
class CrashMatrixIT {
  private static final int RUNS = Integer.getInteger("toqa.crashes", 8);
  private static final int FROM = Integer.getInteger("toqa.crashes.from", 1);
  private static final List<String> STATIONS =
      List.of("Goods-in 1", "Mill", "Store A", "Assembly", "Packing 1", "Goods-out");
  private static final Pattern DELIVERY = Pattern.compile("task (\\d+): phase 2 is done");

  /**
   * As long as batteries last. The robots have nothing but their odometry, and after an hour they
   * would miss a charger.
   */
  private static final int RUNS_OF_A_SITE = 8;

  @TempDir private static Path folder;
  private static CrashSite site;

  @BeforeAll
  static void build() throws Exception {
    site = siteFrom(FROM);
  }

  @AfterAll
  static void clear() throws Exception {
    site.close();
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
                  List<Cut> cuts = Cut.random(random);
                  return DynamicTest.dynamicTest(
                      "seed " + seed + ": " + cuts, () -> run(seed, cuts, random));
                });
    DynamicTest words = DynamicTest.dynamicTest("what the robots say", this::robotsDeliveredOnce);
    return first == FROM
        ? Stream.concat(runs, Stream.of(words))
        : Stream.of(
                Stream.of(DynamicTest.dynamicTest("the next site", () -> moveTo(first))),
                runs,
                Stream.of(words))
            .flatMap(tests -> tests);
  }

  private static CrashSite siteFrom(int seed) throws Exception {
    return new CrashSite(Files.createDirectory(folder.resolve("from-" + seed)));
  }

  private static void moveTo(int seed) throws Exception {
    site.close();
    site = siteFrom(seed);
  }

  private void run(int seed, List<Cut> cuts, Random random) throws Exception {
    List<Long> accepted = new ArrayList<>();
    List<String> refused = new ArrayList<>();
    for (int i = 0; i < 2; i++) {
      ask("run " + seed + " task " + i, random, accepted, refused);
    }
    for (Cut cut : cuts) {
      TimeUnit.MILLISECONDS.sleep(cut.after());
      cut.strike(site);
      try {
        ask("run " + seed + " while " + cut.what(), random, accepted, refused);
        TimeUnit.MILLISECONDS.sleep(cut.lasts());
      } finally {
        cut.mend(site);
      }
    }
    for (long task : accepted) {
      site.server.await("tasks/" + task, CrashMatrixIT::isStoredAsDone);
      assertEquals(1, site.server.happened(task, "Picked up"), () -> told(task));
      assertEquals(1, site.server.happened(task, "Delivered"), () -> told(task));
      assertEquals(1, site.server.happened(task, "Asked for"), () -> told(task));
      assertEquals(1, site.server.happened(task, "Done"), () -> told(task));
    }
    for (JsonNode task : site.server.api().get("tasks?limit=10")) {
      assertTrue(
          !refused.contains(task.get("name").asString()), () -> "refused, but kept: " + task);
    }
  }

  /** What the live task says may be ahead of its history, which is read from the store. */
  private static boolean isStoredAsDone(JsonNode task) {
    JsonNode history = task.get("history");
    return task.get("state").asString().equals("DONE")
        && history.get(history.size() - 1).get("text").asString().equals("Done");
  }

  /** Adds a task to those that must be done or to those that must not; unknown ones to neither. */
  private void ask(String name, Random random, List<Long> accepted, List<String> refused)
      throws InterruptedException {
    int start = random.nextInt(STATIONS.size());
    int goal = (start + 1 + random.nextInt(STATIONS.size() - 1)) % STATIONS.size();
    try {
      Optional<JsonNode> answer =
          site.server
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
    for (String line : site.lastWords()) {
      Matcher delivery = DELIVERY.matcher(line);
      if (delivery.find()) {
        deliveries.merge(Long.valueOf(delivery.group(1)), 1, Integer::sum);
      }
    }
    assertTrue(!deliveries.isEmpty());
    deliveries.values().removeIf(times -> times == 1);
    assertEquals(Map.of(), deliveries);
  }

  private String told(long task) {
    try {
      return site.server.task(task).toPrettyString();
    } catch (Exception e) {
      return e.toString();
    }
  }
}
