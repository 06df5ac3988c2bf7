package org.toqa.app.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Executor;
import org.junit.jupiter.api.Test;

class SteppedRuntimeTest {
  private final SteppedRuntime runtime =
      new SteppedRuntime(Duration.ofMillis(10), Duration.ofMillis(20), Duration.ofNanos(1_000));
  private final List<String> done = new ArrayList<>();

  @Test
  void doesWhatIsDueInOrderAndThenWhatFollowsFromIt() {
    Executor agents = runtime.agentExecutor().orElseThrow();
    runtime.schedule(Duration.ofMillis(15), note("15 ms"));
    Executor store = runtime.serialExecutor("store-r1");
    store.execute(
        () -> {
          note("stored").run();
          agents.execute(note("agent"));
        });
    store.execute(note("stored too"));
    runtime.schedule(Duration.ofMillis(21), note("21 ms"));

    runtime.advanceTo(20_000_000);

    assertEquals(List.of("stored at 10", "agent at 10", "stored too at 10", "15 ms at 15"), done);
    assertEquals(20_000_000, runtime.nanos());
    runtime.advanceTo(30_000_000);
    assertEquals("21 ms at 21", done.getLast());
  }

  @Test
  void theTimeOfPlanningCountsLooks() {
    assertEquals(1_000, runtime.nanoTime());
    assertEquals(2_000, runtime.nanoTime());
  }

  private Runnable note(String word) {
    return () -> done.add(word + " at " + runtime.nanos() / 1_000_000);
  }
}
