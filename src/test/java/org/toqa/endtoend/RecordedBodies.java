package org.toqa.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.toqa.grid.FloorReader;
import org.toqa.sim.Body;
import org.toqa.sim.ClearanceJudge;
import org.toqa.sim.ClearanceJudge.Clearance;
import tools.jackson.databind.json.JsonMapper;

/** Where bodies really were on the shipped floor, as {@code toqa demo --bodies} wrote it. */
final class RecordedBodies {
  /** Seconds of the world between two lines. */
  private static final double STEP = 0.02;

  private final ClearanceJudge judge;
  private final Map<String, ClearanceJudge> elsewhere = new HashMap<>();
  private final RobotTracks tracks = new RobotTracks();
  private final Set<String> robots = new TreeSet<>();
  private final Set<String> loads = new TreeSet<>();

  /** A line of the file. */
  private record Moment(double seconds, String floor, List<Body> bodies) {}

  private RecordedBodies(ClearanceJudge judge) {
    this.judge = judge;
  }

  /**
   * Reads what is written so far; what comes after the last end of a line is not yet.
   *
   * @throws IOException the file cannot be read
   */
  static RecordedBodies read(Path file) throws IOException {
    RecordedBodies bodies =
        new RecordedBodies(
            new ClearanceJudge(FloorReader.read(Path.of("maps", "lab.yaml")).grid()));
    String written = Files.readString(file);
    double before = Double.NaN;
    for (String line : written.substring(0, written.lastIndexOf('\n') + 1).lines().toList()) {
      Moment moment = JsonMapper.shared().readValue(line, Moment.class);
      if (moment.floor().equals("lab")) {
        bodies.add(Double.isNaN(before) ? moment.seconds() - STEP : before, moment);
        before = moment.seconds();
      } else {
        bodies.judgeElsewhere(moment);
      }
    }
    return bodies;
  }

  /** On the other floors robots touch each other and walls as little. */
  private void judgeElsewhere(Moment moment) throws IOException {
    ClearanceJudge other = elsewhere.get(moment.floor());
    if (other == null) {
      other =
          new ClearanceJudge(
              FloorReader.read(Path.of("maps", moment.floor() + ".yaml")).drawing().walls());
      elsewhere.put(moment.floor(), other);
    }
    other.judge(Duration.ofNanos(Math.round(moment.seconds() * 1e9)), moment.bodies());
  }

  private void add(double secondsBefore, Moment moment) {
    assertEquals(STEP, moment.seconds() - secondsBefore, 1e-6, "a moment is missing");
    for (Body body : moment.bodies()) {
      (body.carriers().isEmpty() ? robots : loads).add(body.name());
      if (body.carriers().isEmpty()) {
        tracks.add(body.name(), body.core().getFirst());
      }
    }
    long seen = moment.bodies().stream().filter(body -> body.carriers().isEmpty()).count();
    assertEquals(robots.size(), seen, () -> "robots have gone from " + moment);
    judge.judge(Duration.ofNanos(Math.round(moment.seconds() * 1e9)), moment.bodies());
  }

  /**
   * No robot, and no load of a group, has touched another one or a wall; and there were so many
   * robots, and at least one such load.
   */
  void assertClear(int expectedRobots) {
    assertEquals(expectedRobots, robots.size(), robots::toString);
    assertFalse(loads.isEmpty(), "no group was seen with its load");
    assertTrue(judge.samples() > 1000, "only " + judge.samples() + " moments were written");
    Clearance bodies = judge.betweenBodies().orElseThrow();
    assertFalse(bodies.isTouch(), bodies::toString);
    Clearance wall = judge.toWall().orElseThrow();
    assertFalse(wall.isTouch(), wall::toString);
    elsewhere.forEach(
        (floor, other) -> {
          assertFalse(other.toWall().orElseThrow().isTouch(), floor);
          assertFalse(other.betweenBodies().filter(Clearance::isTouch).isPresent(), floor);
        });
  }

  /** The pairs of robots that passed a cell in different directions, such as {@code r1 x r4}. */
  Set<String> crossings() {
    return tracks.crossings();
  }
}
