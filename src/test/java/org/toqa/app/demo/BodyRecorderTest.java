package org.toqa.app.demo;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.sim.Body;

class BodyRecorderTest {
  @TempDir private Path folder;

  @Test
  void everyMomentIsALineThatCanBeReadAtOnce() throws Exception {
    Path file = folder.resolve("bodies.jsonl");
    try (BodyRecorder recorder = BodyRecorder.create(file)) {
      recorder.write(Duration.ofMillis(20), "lab", List.of(Body.disc("r1", new Vec2(1, 2), 0.25)));
      recorder.write(
          Duration.ofMillis(1040),
          "store",
          List.of(Body.load("load", new Pose(0, 0, 0), 4, 2, Set.of("r1"))));

      assertEquals(
          List.of(
              "{\"seconds\":0.02,\"floor\":\"lab\",\"bodies\":[{\"name\":\"r1\",\"core\":[{\"x\":1.0,\"y\":2.0}],"
                  + "\"radius\":0.25,\"carriers\":[]}]}",
              "{\"seconds\":1.04,\"floor\":\"store\",\"bodies\":[{\"name\":\"load\",\"core\":[{\"x\":2.0,\"y\":1.0},"
                  + "{\"x\":-2.0,\"y\":1.0},{\"x\":-2.0,\"y\":-1.0},{\"x\":2.0,\"y\":-1.0}],"
                  + "\"radius\":0.0,\"carriers\":[\"r1\"]}]}"),
          Files.readAllLines(file));
    }
  }
}
