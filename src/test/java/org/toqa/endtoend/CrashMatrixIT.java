package org.toqa.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.TreeMap;
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

/**
 * Server, daemons, database and links are cut or frozen at random moments while robots carry, alone
 * and together, and charge, and while people order, import, schedule, cancel and hold. Every task
 * that was accepted ends DONE once, or CANCELLED where that was accepted; what was refused is never
 * done; what is held really stands still, and no two bodies ever touch.
 *
 * <p>{@code -Dtoqa.crashes=200} for so many runs, {@code -Dtoqa.seed=17} to begin with another
 * seed: the same seed gives the same plan.
 */
@Tag("full")
class CrashMatrixIT {
  private static final int RUNS = Integer.getInteger("toqa.crashes", 5);
  private static final int FROM = Integer.getInteger("toqa.seed", 1);

  /** Such as {@code carl task 7: phase 2 is done}. */
  private static final Pattern DELIVERY = Pattern.compile("(\\S+) task (\\d+): phase 2 is done");

  /** Of more runs each says its result when it ends. */
  private static final int SILENT_RUNS = 20;

  /** Two of the robots have nothing but their odometry, and would miss a charger some day. */
  private static final int RUNS_OF_A_SITE = 5;

  @TempDir private static Path folder;
  private static CrashTestbed testbed;

  /** Whether a run has failed at it, and left there what it left. */
  private static boolean isSpoilt;

  /** What was done in all runs, by kind. */
  private static final Map<String, Long> counts = new TreeMap<>();

  @BeforeAll
  static void build() throws Exception {
    testbed = newTestbed(FROM);
  }

  @AfterAll
  static void clear() throws Exception {
    counts.forEach(Tally::add);
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
            .mapToObj(CrashPlan::of)
            .map(plan -> DynamicTest.dynamicTest(plan.toString(), () -> run(plan)));
    Stream<DynamicTest> words =
        Stream.of(
            DynamicTest.dynamicTest("what the robots say", this::robotsDeliveredOnce),
            DynamicTest.dynamicTest("what was done", () -> allWasDone(end - first)));
    Stream<DynamicTest> site =
        first == FROM
            ? Stream.of()
            : Stream.of(DynamicTest.dynamicTest("the next site", () -> replaceTestbed(first)));
    return Stream.of(site, runs, words).flatMap(tests -> tests);
  }

  private static CrashTestbed newTestbed(int seed) throws Exception {
    return new CrashTestbed(Files.createDirectory(folder.resolve("from-" + seed)));
  }

  private static void replaceTestbed(int seed) throws Exception {
    testbed.close();
    testbed = newTestbed(seed);
    isSpoilt = false;
  }

  /** Says its result at once where there are many, so that those who wait see how it goes. */
  private void run(CrashPlan plan) throws Exception {
    long start = System.nanoTime();
    String result = "failed";
    try {
      judge(plan);
      result = "nothing lost, nothing done twice";
    } catch (Exception | AssertionError e) {
      result = "failed: " + String.valueOf(e.getMessage()).lines().findFirst().orElse("");
      throw e;
    } finally {
      if (RUNS > SILENT_RUNS) {
        System.out.printf(
            "crashes, seed %d: %.1f s, %s%n",
            plan.seed(), (System.nanoTime() - start) / 1e9, result);
      }
    }
  }

  private void judge(CrashPlan plan) throws Exception {
    if (isSpoilt) {
      replaceTestbed(plan.seed());
    }
    isSpoilt = true;
    CrashRun run = new CrashRun(testbed, plan);
    run.run();
    isSpoilt = false;
    counts.merge("runs with crashes", 1L, Long::sum);
    run.counts().forEach((kind, count) -> counts.merge(kind + " among crashes", count, Long::sum));
  }

  private void robotsDeliveredOnce() throws Exception {
    Map<String, Integer> deliveries = new HashMap<>();
    for (String line : testbed.errorOutput()) {
      Matcher delivery = DELIVERY.matcher(line);
      if (delivery.find()) {
        deliveries.merge(delivery.group(1) + " task " + delivery.group(2), 1, Integer::sum);
      }
    }
    assertTrue(!deliveries.isEmpty());
    deliveries.values().removeIf(times -> times == 1);
    assertEquals(Map.of(), deliveries);
  }

  /** Also of each kind of work, where the runs were enough for all. */
  private void allWasDone(int runsOfSite) {
    counts.merge("charges among crashes", (long) testbed.truth().charges(), Long::sum);
    counts.merge("moments among crashes", testbed.truth().moments(), Long::sum);
    if (runsOfSite == RUNS_OF_A_SITE) {
      for (Work.Kind kind : Work.Kind.values()) {
        assertTrue(counts.getOrDefault(kind.plural() + " among crashes", 0L) > 0, kind::plural);
      }
      assertTrue(testbed.truth().charges() > 0, "no robot was charged");
    }
  }
}
