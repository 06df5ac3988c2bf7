package org.toqa.endtoend;

import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.function.IntToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What the film's judge finds in files of which the truth is known. */
class RecordedBodiesTest {
  private static final double HALL_Y = 6.75;

  @TempDir private Path folder;

  @Test
  void bodiesThatKeepApartAreClearAndAPartOfALineIsNotReadYet() throws Exception {
    Path file = written(i -> 4, "{\"seconds\":77,\"bod");
    RecordedBodies.read(file).assertClear(2);
  }

  @Test
  void bodiesThatTouchInOneMomentAreFound() throws Exception {
    RecordedBodies seen = RecordedBodies.read(written(i -> i == 700 ? 3.25 : 4, ""));
    AssertionError error = assertThrows(AssertionError.class, () -> seen.assertClear(2));
    // 0.25 m between the middles of two robots of 0.255 m
    assertTrue(String.valueOf(error.getMessage()).contains("-0.0050 m"), error::toString);
  }

  @Test
  void loadThatAnotherRobotDrivesIntoIsFound() throws Exception {
    RecordedBodies seen = RecordedBodies.read(written(i -> i == 700 ? 6.2 : 4, ""));
    assertThrows(AssertionError.class, () -> seen.assertClear(2));
  }

  @Test
  void robotInAWallIsFound() throws Exception {
    RecordedBodies seen = RecordedBodies.read(written(i -> i == 700 ? 0.1 : 4, ""));
    AssertionError error = assertThrows(AssertionError.class, () -> seen.assertClear(2));
    assertTrue(String.valueOf(error.getMessage()).contains("wall"), error::toString);
  }

  @Test
  void robotThatIsNotThereAndMomentThatIsMissingAreFound() throws Exception {
    Path file = written(i -> 4, "");
    String all = Files.readString(file);
    RecordedBodies seen = RecordedBodies.read(file);
    assertThrows(AssertionError.class, () -> seen.assertClear(3));

    String[] lines = all.split("\n");
    lines[5] = lines[6];
    Files.writeString(file, String.join("\n", lines) + "\n");
    assertThrows(AssertionError.class, () -> RecordedBodies.read(file));
  }

  /**
   * r1 stands in the hall, r2 is moved; a load stands farther on, r1 is one of its carriers.
   *
   * @param x of r2, by the number of the moment
   */
  private Path written(IntToDoubleFunction x, String rest) throws IOException {
    StringBuilder lines = new StringBuilder();
    for (int i = 0; i < 1200; i++) {
      lines.append(
          String.format(
              Locale.ROOT,
              "{\"seconds\":%.2f,\"floor\":\"lab\",\"bodies\":["
                  + "{\"name\":\"r1\",\"core\":[{\"x\":3.0,\"y\":%2$s}],"
                  + "\"radius\":0.1275,\"carriers\":[]},"
                  + "{\"name\":\"r2\",\"core\":[{\"x\":%3$s,\"y\":%2$s}],"
                  + "\"radius\":0.1275,\"carriers\":[]},"
                  + "{\"name\":\"load of task 1\",\"core\":[{\"x\":6.3,\"y\":6.6},"
                  + "{\"x\":6.6,\"y\":6.6},{\"x\":6.6,\"y\":6.9},{\"x\":6.3,\"y\":6.9}],"
                  + "\"radius\":0.0,\"carriers\":[\"r1\",\"r3\"]}]}%n",
              i * 0.02,
              HALL_Y,
              x.applyAsDouble(i)));
    }
    return Files.writeString(folder.resolve("bodies.jsonl"), lines + rest);
  }
}
