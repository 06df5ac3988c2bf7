package org.toqa.traffic.floor;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.TestFactory;

/** Every file under {@code src/test/resources/traffic} is driven, each a few times. */
@Tag("full")
class FloorScenariosTest {
  private static final int TIMES = 5;

  @TestFactory
  Stream<DynamicTest> scenariosComeOutAsTheyShall() throws IOException, URISyntaxException {
    Path folder = Path.of(Objects.requireNonNull(getClass().getResource("/traffic")).toURI());
    List<Path> files;
    try (Stream<Path> found = Files.list(folder)) {
      files = found.filter(f -> f.toString().endsWith(".txt")).sorted().toList();
    }
    return files.stream()
        .flatMap(
            file ->
                LongStream.rangeClosed(1, TIMES)
                    .mapToObj(
                        seed ->
                            DynamicTest.dynamicTest(
                                file.getFileName() + ", seed " + seed, () -> drive(file, seed))));
  }

  private static void drive(Path file, long seed) throws IOException {
    assertEquals(List.of(), new FloorScenario(Files.readString(file, UTF_8)).faults(seed));
  }
}
