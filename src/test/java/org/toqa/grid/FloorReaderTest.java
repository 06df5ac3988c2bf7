package org.toqa.grid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.toqa.grid.MapFiles.assertRefused;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.toqa.geometry.Vec2;

class FloorReaderTest {
  private final Path folder;
  private final MapFiles files;
  private final Path map;

  /** 4 x 3 cells of 1 m, all free but the upper left one. */
  FloorReaderTest(@TempDir Path folder) throws IOException {
    this.folder = folder;
    files = new MapFiles(folder);
    map = files.write("hall.map", "type octile\nheight 3\nwidth 4\nmap\n@...\n....\n....\n");
  }

  @Test
  void floorWithoutAnythingElseIsItsGrid() throws IOException {
    FloorMap floor = FloorReader.read(map);
    assertEquals("hall", floor.name());
    assertEquals(OccupancyGrid.parse("#...", "....", "...."), floor.grid());
    assertEquals(List.of(), floor.stations());
    assertEquals(Moves.HEADING, floor.moves());
  }

  @Test
  void placesAndKeepOutZonesAreRead() throws IOException {
    files.write(
        "hall.floor.yaml",
        """
        stations:
          - {name: Packing, x: 0.5, y: 1.5}
        parking:
          - {name: P1, x: 3.5, y: 0.5}
        charging:
          - {name: C1, x: 3.5, y: 2.5}
        keepOut:
          - {x: 1, y: 0, width: 1.2, height: 1}
          - {x: -50, y: 2.5, width: 52, height: 100}
        moves: smooth
        """);
    FloorMap floor = FloorReader.read(map);
    assertEquals(OccupancyGrid.parse("##..", "....", ".##."), floor.grid());
    assertEquals(List.of(new Place("Packing", new Vec2(0.5, 1.5))), floor.stations());
    assertEquals(Optional.of(new Place("C1", new Vec2(3.5, 2.5))), floor.place("C1"));
    assertTrue(floor.place("P2").isEmpty());
    assertEquals(Moves.SMOOTH, floor.moves());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      textBlock =
          """
          staions: []                                              | did you mean 'stations'
          stations: {name: A}                                      | expected a list
          stations: [A]                                            | stations number 1
          stations: [{name: A, x: 1.5}]                            | key 'y': is missing
          stations: [{name: A, x: 1.5, z: 2}]                      | unknown key 'z'
          stations: [{name: A, x: 0.5, y: 2.5}]                    | in a wall
          stations: [{name: A, x: 4.5, y: 2.5}]                    | off the map
          stations: [{name: A, x: .nan, y: 2.5}]                   | finite
          stations: [{name: A, x: 1e9, y: 2.5}]                    | at most 100000
          stations: [{name: '', x: 1.5, y: 1.5}]                   | 1 to 64 letters
          stations: [{name: "A\\u200F", x: 1.5, y: 1.5}]             | all of which can be shown
          stations: [{name: 7, x: 1.5, y: 1.5}]                    | quotes
          keepOut: [{x: 1, y: 1, width: 0, height: 1}]             | larger than 0
          moves: curvy                                             | one of heading, smooth, not 'curvy'
          moves: [smooth]                                          | key 'moves': expected text
          !!javax.script.ScriptEngineManager []                    | not valid YAML
          just text                                                | expected keys
          """)
  void wrongFloorIsRefusedWithAReason(String text, String reason) throws IOException {
    files.write("hall.floor.yaml", text);
    assertRefused(map, "hall.floor.yaml", reason);
  }

  @Test
  void nameThatIsThereTwiceIsRefused() throws IOException {
    files.write(
        "hall.floor.yaml",
        """
        stations: [{name: A, x: 1.5, y: 1.5}]
        parking: [{name: A, x: 2.5, y: 1.5}]
        """);
    assertRefused(map, "parking number 1", "twice");
  }

  @Test
  void fileOfAnotherKindIsRefused() throws IOException {
    assertRefused(files.write("hall.txt", ""), ".yaml file");
    assertRefused(folder.resolve("nowhere.yaml"), "no file");
    assertRefused(files.write("hall.floor.yaml", ""), "map's own");
  }
}
