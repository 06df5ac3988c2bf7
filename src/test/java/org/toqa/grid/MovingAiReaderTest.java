package org.toqa.grid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.toqa.grid.MapFiles.assertRefused;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class MovingAiReaderTest {
  private final MapFiles files;

  MovingAiReaderTest(@TempDir Path folder) {
    files = new MapFiles(folder);
  }

  @Test
  void terrainIsPassableByTheBenchmarksConvention() throws IOException {
    Path file = files.write("a.map", "type octile\nheight 2\nwidth 4\nmap\n.GS@\nOTW.\n");
    assertEquals(OccupancyGrid.parse("...#", "###."), MovingAiReader.read(file));
  }

  @Test
  void filesMayBeginWithAByteOrderMark() throws IOException {
    Path map = files.write("a.map", "\uFEFFtype octile\r\nheight 1\r\nwidth 2\r\nmap\r\n.@\r\n");
    Path scenarios = files.write("a.map.scen", "\uFEFFversion 1\r\n3\ta\t2\t1\t0\t0\t0\t0\t0\r\n");

    assertEquals(OccupancyGrid.parse(".#"), MovingAiReader.read(map));
    assertEquals(1, ScenarioReader.read(scenarios).size());
  }

  @Test
  void wrongMapsAreRefusedWithTheLine() throws IOException {
    assertRefused(files.write("a.map", "type tile\n"), "line 1", "type octile");
    assertRefused(files.write("b.map", "type octile\nheight x\n"), "line 2", "height");
    assertRefused(
        files.write("c.map", "type octile\nheight 2\nwidth 2\nmap\n..\n.\n"), "line 6", "1 cells");
    assertRefused(
        files.write("d.map", "type octile\nheight 2\nwidth 2\nmap\n..\n"), "line 6", "0 cells");
    assertRefused(
        files.write("e.map", "type octile\nheight 999999999\nwidth 999999999\nmap\n"), "split");
    assertRefused(files.write("f.map", ""), "line 1");
  }

  @Test
  void scenarioIsRead() throws IOException {
    Path file =
        files.write("a.map.scen", "version 1\n3\ta b.map\t4\t2\t0\t0\t2\t0\t2.00000000\n\n");
    assertEquals(
        List.of(new Scenario(3, "a b.map", 4, 2, new Cell(0, 0), new Cell(2, 0), 2)),
        ScenarioReader.read(file));
  }

  @Test
  void wrongScenariosAreRefusedWithTheLine() throws IOException {
    assertScenarioRefused("0 a 2 2 0 0 1 1 1.4\n", "line 1");
    assertScenarioRefused("version 1\n0 a 2 2 0 0 1 1\n", "line 2: 8 columns");
    assertScenarioRefused("version 1\n0 a 2 2 0 0 1 z 1.4\n", "line 2: a column");
    assertScenarioRefused("version 1\n0 a 2 2 0 0 1 2 1.4\n", "off the map");
  }

  private void assertScenarioRefused(String text, String words) throws IOException {
    Path file = files.write("wrong.scen", text);
    MapFormatException refusal =
        assertThrows(MapFormatException.class, () -> ScenarioReader.read(file));
    assertTrue(String.valueOf(refusal.getMessage()).contains(words), refusal::getMessage);
  }
}
