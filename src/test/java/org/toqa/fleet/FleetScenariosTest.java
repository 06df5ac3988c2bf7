package org.toqa.fleet;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Every file under {@code src/test/resources/fleet} is played; see {@link FleetScenario}. */
@Tag("full")
class FleetScenariosTest {
  @TestFactory
  @Timeout(300)
  Stream<DynamicTest> scenariosComeOutAsTheyShall() throws IOException, URISyntaxException {
    return files().stream()
        .map(
            file ->
                DynamicTest.dynamicTest(
                    String.valueOf(file.getFileName()),
                    () -> assertNull(new FleetScenario(Files.readString(file, UTF_8)).fault())));
  }

  /** Though the second time every processor has something else to do as well. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "charging-queue-of-three.txt",
        "heavy-load-one-robot-held.txt",
        "nearer-robot-takes-over.txt"
      })
  @Timeout(120)
  void sameScenarioIsTheSameRun(String name) throws Exception {
    String text = Files.readString(folder().resolve(name), UTF_8);
    int alone = digest(text);
    AtomicBoolean isOver = new AtomicBoolean();
    List<Thread> others =
        IntStream.range(0, 2 * Runtime.getRuntime().availableProcessors())
            .mapToObj(i -> Thread.ofPlatform().daemon().start(() -> keepBusy(isOver)))
            .toList();
    try {
      assertEquals(alone, digest(text));
    } finally {
      isOver.set(true);
      for (Thread other : others) {
        other.join();
      }
    }
  }

  private static int digest(String text) throws Exception {
    FleetScenario scenario = new FleetScenario(text);
    assertNull(scenario.fault());
    return scenario.digest();
  }

  private static void keepBusy(AtomicBoolean isOver) {
    while (!isOver.get()) {
      Thread.onSpinWait();
    }
  }

  private static List<Path> files() throws IOException, URISyntaxException {
    try (Stream<Path> found = Files.list(folder())) {
      return found.filter(f -> f.toString().endsWith(".txt")).sorted().toList();
    }
  }

  private static Path folder() throws URISyntaxException {
    return Path.of(Objects.requireNonNull(FleetScenariosTest.class.getResource("/fleet")).toURI());
  }
}
