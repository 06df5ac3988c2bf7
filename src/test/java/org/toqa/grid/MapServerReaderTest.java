package org.toqa.grid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.toqa.grid.MapFiles.assertRefused;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.geometry.Vec2;

class MapServerReaderTest {
  private final Path folder;
  private final MapFiles files;

  MapServerReaderTest(@TempDir Path folder) throws IOException {
    this.folder = folder;
    files = new MapFiles(folder);
    files.write("floor.pgm", MapFiles.PGM);
  }

  private static void assertSixCells(OccupancyGrid grid) {
    OccupancyGrid expected = OccupancyGrid.parse(".##", "...");
    assertEquals(new OccupancyGrid(3, 2, 0.5, new Vec2(1, 2), expected.occupied()), grid);
  }

  @Test
  void pictureInTextIsRead() throws IOException {
    OccupancyGrid grid = MapServerReader.read(files.write("floor.yaml", MapFiles.YAML));
    assertSixCells(grid); // the unknown cell counts as occupied
    assertEquals(new Vec2(1.25, 2.75), grid.centre(new Cell(0, 0)));
  }

  @Test
  void binaryPictureIsRead() throws IOException {
    byte[] pixels = {(byte) 254, (byte) 205, 0, (byte) 255, (byte) 254, (byte) 254};
    byte[] header = "P5\n3 2\n255\n".getBytes(StandardCharsets.US_ASCII);
    byte[] picture = Arrays.copyOf(header, header.length + pixels.length);
    System.arraycopy(pixels, 0, picture, header.length, pixels.length);
    Files.write(folder.resolve("floor.pgm"), picture);
    assertSixCells(MapServerReader.read(files.write("floor.yaml", MapFiles.YAML)));
  }

  @ParameterizedTest
  @ValueSource(
      ints = {
        BufferedImage.TYPE_BYTE_GRAY,
        BufferedImage.TYPE_USHORT_GRAY,
        BufferedImage.TYPE_INT_RGB,
        BufferedImage.TYPE_INT_ARGB,
        BufferedImage.TYPE_BYTE_INDEXED
      })
  void pngOfEveryKindIsRead(int type) throws IOException {
    int[][] greys = {{254, 205, 0}, {255, 254, 254}};
    BufferedImage image = new BufferedImage(3, 2, type);
    for (int i = 0; i < 6; i++) {
      int grey = greys[i / 3][i % 3];
      if (type == BufferedImage.TYPE_BYTE_GRAY) {
        image.getRaster().setSample(i % 3, i / 3, 0, grey);
      } else if (type == BufferedImage.TYPE_USHORT_GRAY) {
        image.getRaster().setSample(i % 3, i / 3, 0, grey * 257);
      } else {
        image.setRGB(i % 3, i / 3, new Color(grey, grey, grey).getRGB());
      }
    }
    ImageIO.write(image, "png", folder.resolve("floor.png").toFile());
    assertSixCells(
        MapServerReader.read(files.write("floor.yaml", MapFiles.YAML.replace("pgm", "png"))));
  }

  @Test
  void transparentPixelIsUnknownAndSoOccupied() throws IOException {
    BufferedImage image = new BufferedImage(2, 1, BufferedImage.TYPE_INT_ARGB);
    image.setRGB(0, 0, Color.WHITE.getRGB());
    image.setRGB(1, 0, 0x00FFFFFF);
    ImageIO.write(image, "png", folder.resolve("floor.png").toFile());
    OccupancyGrid grid =
        MapServerReader.read(files.write("floor.yaml", MapFiles.YAML.replace("pgm", "png")));
    assertEquals(OccupancyGrid.parse(".#").occupied(), grid.occupied());
  }

  @Test
  void negatedPictureHasLightWalls() throws IOException {
    files.write("floor.pgm", "P2 2 1 255 0 255");
    OccupancyGrid grid =
        MapServerReader.read(
            files.write("floor.yaml", MapFiles.YAML.replace("negate: 0", "negate: 1")));
    assertEquals(OccupancyGrid.parse(".#").occupied(), grid.occupied());
  }

  @ParameterizedTest
  @CsvSource({
    "trinary, 255 230 100 0, ..##",
    "scale, 255 230 100 0, ..##",
    "raw, 0 10 60 200, ..##",
    "raw, 255 18 20 100, #.##"
  })
  void greysAreReadAsTheModeSays(String mode, String greys, String cells) throws IOException {
    files.write("floor.pgm", "P2 4 1 255 " + greys);
    OccupancyGrid grid =
        MapServerReader.read(files.write("floor.yaml", MapFiles.YAML + "mode: " + mode + "\n"));
    assertEquals(OccupancyGrid.parse(cells).occupied(), grid.occupied());
  }

  /** A quarter of a turn: the picture's bottom row is the map's right column, from below. */
  @Test
  void pictureThatIsTurnedByARightAngleIsTheSameFloor() throws IOException {
    OccupancyGrid grid =
        MapServerReader.read(
            files.write("floor.yaml", MapFiles.YAML.replace("2.0, 0.0]", "2.0, 1.5707963268]")));
    OccupancyGrid expected = OccupancyGrid.parse("#.", "#.", "..");
    assertEquals(expected.occupied(), grid.occupied());
    assertEquals(2, grid.width());
    assertEquals(0, grid.origin().distanceTo(new Vec2(0, 2)), 1e-9);
  }

  /** Walls of a turned picture: no point in one of them is in a free cell, by any angle. */
  @ParameterizedTest
  @ValueSource(doubles = {0.3, -1, 2.5, 6})
  void noPointInAWallOfATurnedPictureIsFree(double angle) throws IOException {
    files.write("floor.pgm", "P2 9 3 255 " + "254 ".repeat(13) + "0 " + "254 ".repeat(13));
    OccupancyGrid grid =
        MapServerReader.read(
            files.write("floor.yaml", MapFiles.YAML.replace("2.0, 0.0]", "2.0, " + angle + "]")));
    Vec2 corner = new Vec2(1, 2);
    for (double along = 0.01; along < 1; along += 0.05) {
      for (double across = 0.01; across < 1; across += 0.05) {
        Vec2 inWall = new Vec2((4 + along) * 0.5, (1 + across) * 0.5);
        assertFalse(grid.isFree(corner.plus(inWall.rotated(angle))), "at " + inWall);
      }
    }
    assertTrue(grid.isFree(corner.plus(new Vec2(1, 0.75).rotated(angle))));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          resolution: 0.5           | resolution: 0              | resolution
          resolution: 0.5           | resolution: .nan           | finite
          resolution: 0.5           | resolution: half           | finite
          resolution: 0.5           | resolutoin: 0.5            | did you mean 'resolution'
          resolution: 0.5           |                            | missing
          origin: [1.0, 2.0, 0.0]   | origin: [1.0, 2.0, 90]     | radians
          origin: [1.0, 2.0, 0.0]   | origin: [1.0, 2.0]         | list of 3
          origin: [1.0, 2.0, 0.0]   | origin: [.inf, 2.0, 0]     | finite
          origin: [1.0, 2.0, 0.0]   | origin: [1e30, 2.0, 0]     | 100000
          negate: 0                 | negate: 2                  | dark is occupied
          negate: 0                 | mode: grey                 | trinary
          free_thresh: 0.196        | free_thresh: 0.9           | larger than occupied_thresh
          free_thresh: 0.196        | free_thresh: -1            | between 0 and 1
          image: floor.pgm          | image: floor.bmp           | .pgm or .png
          image: floor.pgm          | image: nowhere.pgm         | no file
          image: floor.pgm          | image: 7                   | quotes
          negate: 0                 | 'negate: 0, negate: 1'     | not valid YAML
          negate: 0                 | resolution: 0.5            | not valid YAML
          """)
  void wrongYamlIsRefusedWithAReason(String right, String wrong, String reason) throws IOException {
    String text = MapFiles.YAML.replace(right, wrong == null ? "" : wrong);
    assertRefused(files.write("floor.yaml", text), reason);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          P6 2 1 255 0 0            | P2 or P5
          P2 0 1 255                | at least 1
          P2 5000 5000 255 0        | larger cells
          P2 2 1 255 0              | grey value 2 of 2
          P2 2 1 255 0 x            | grey value 2 of 2
          P2 2 1 255 0 256          | column 1, row 0
          P2 2 1 70000 0 0          | 65535
          P5 2 9 255 abc            | ends after
          P2                        | width
          """)
  void wrongPictureIsRefusedWithAReason(String picture, String reason) throws IOException {
    files.write("floor.pgm", picture);
    assertRefused(files.write("floor.yaml", MapFiles.YAML), "floor.pgm", reason);
  }

  @Test
  void fileThatIsNoPngIsRefused() throws IOException {
    files.write("floor.png", "P2 1 1 255 0");
    assertRefused(
        files.write("floor.yaml", MapFiles.YAML.replace("pgm", "png")), "not a readable PNG");
  }
}
