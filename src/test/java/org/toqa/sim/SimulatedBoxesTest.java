package org.toqa.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.geometry.Vec2;
import org.toqa.sim.SimulatedBoxes.Placed;

class SimulatedBoxesTest {
  private static final Vec2 HERE = new Vec2(1, 2);
  private static final Vec2 THERE = new Vec2(5, 2);
  private static final List<Placed> BOXES =
      List.of(new Placed(1, HERE, 1.5), new Placed(7, new Vec2(3, 2), 8));

  @TempDir private Path folder;

  private SimulatedBoxes open() throws IOException {
    return SimulatedBoxes.open(folder.resolve("robots/boxes"), BOXES);
  }

  @Test
  void handGraspsWhatLiesThereAndNothingElse() throws IOException {
    SimulatedBoxes boxes = open();
    assertEquals(0, boxes.grasp("r1", new Vec2(1.2, 2)), "it is 0.2 m off");
    assertEquals(1.5, boxes.grasp("r1", new Vec2(1.05, 2)));
    assertEquals(Optional.empty(), boxes.placeOf(1));
    assertEquals(0, boxes.grasp("r2", HERE), "another one has it");
    boxes.release("r1", THERE);
    assertEquals(Optional.of(THERE), boxes.placeOf(1));
  }

  @Test
  void whatSeveralLiftMovesWithThem() throws IOException {
    SimulatedBoxes boxes = open();
    boxes.lift(4, new Vec2(3.1, 2));
    assertEquals(Set.of(1), boxes.lying().keySet());
    boxes.setDown(4, THERE);
    assertEquals(Map.of(1, HERE, 7, THERE), boxes.lying());
  }

  @Test
  void boxesAreWhereTheyWereWhenTheProcessWasKilled() throws IOException {
    SimulatedBoxes before = open();
    before.grasp("r1", HERE);
    before.lift(4, new Vec2(3, 2));
    before.setDown(4, THERE);
    SimulatedBoxes after = open();
    assertEquals(Map.of(7, THERE), after.lying());
    assertEquals(1.5, after.grasp("r1", THERE), "it has it in its hand still");
    after.release("r1", HERE);
    assertEquals(Map.of(1, HERE, 7, THERE), open().lying());
  }

  @Test
  void fileThatIsWrongSaysWhereAndWhat() throws IOException {
    Path file = folder.resolve("store.boxes.yaml");
    Files.writeString(
        file,
        """
        floor: store
        arms: [r1]
        cameras: [r3]
        cameraRange: 4
        boxes:
          - {number: 1, x: 3.25, y: 7.5, weight: 1.8}
        """);
    assertEquals(
        new SimulatedStore(
            "store",
            Set.of("r1"),
            Set.of("r3"),
            4,
            List.of(new Placed(1, new Vec2(3.25, 7.5), 1.8))),
        SimulatedStore.read(file));
    Files.writeString(file, "floor: store\nboxs: []\n");
    IOException wrong = assertThrows(IOException.class, () -> SimulatedStore.read(file));
    assertTrue(
        String.valueOf(wrong.getMessage()).startsWith(file + ": \"boxs\" is not known"),
        wrong::toString);
  }
}
