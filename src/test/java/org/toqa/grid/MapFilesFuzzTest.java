package org.toqa.grid;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Random;
import java.util.zip.CRC32;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Vec2;
import org.toqa.testbed.FuzzRun;
import org.toqa.testbed.Splice;

/**
 * Files of maps with bytes that were changed, lost or added: each is read, or refused with a
 * sentence, and none takes more cells than a map may have.
 */
class MapFilesFuzzTest {
  private static final List<String> WORDS =
      List.of(
          "0",
          "-1",
          "1e308",
          "1e-320",
          ".nan",
          ".inf",
          "99999999999",
          "2147483647",
          "4096",
          "[]",
          "{}",
          "[0, 0]",
          "&a [*a]",
          "!!java.net.URL x",
          "!!int abc",
          "!!float abc",
          "!!binary \"%\"",
          "!!timestamp x",
          "\"\\U00110000\"",
          "null",
          "../x.pgm",
          "P5",
          "P2",
          "type octile",
          "height 100000",
          "width 0",
          "\u0000",
          "\ufeff",
          "raw",
          "scale");

  private final Random random = new Random(FuzzRun.SEED);
  private long read;

  @Test
  void noFileOfAMapDoesHarm() throws IOException {
    List<Map<String, byte[]>> correct = correct();
    long begin = System.nanoTime();
    for (long i = 0; i < FuzzRun.INPUTS; i++) {
      tryOne(mutated(correct.get(random.nextInt(correct.size()))));
    }
    long inputs = FuzzRun.INPUTS;
    assertTrue(read > inputs / 20 && read < inputs * 19 / 20, read + " could be read");
    FuzzRun.tell("the readers of maps", inputs, "%,d could be read".formatted(read), begin);
  }

  private void tryOne(Map<String, byte[]> files) {
    try {
      FloorDrawing drawing = drawing(files);
      assertTrue((long) drawing.walls().width() * drawing.walls().height() <= MapLimits.MAX_CELLS);
      read++;
    } catch (MapFormatException e) {
      assertFalse(String.valueOf(e.getMessage()).isBlank());
    }
  }

  private static FloorDrawing drawing(Map<String, byte[]> files) throws MapFormatException {
    String first = files.keySet().iterator().next();
    byte[] content = files.values().iterator().next();
    return switch (first) {
      case "map.zip" -> FloorReader.read(MapArchive.unpack(content)).drawing();
      case "plan.png" -> FloorPicture.read(first, content, 0.1, 0.5);
      default -> FloorReader.read(MapArchive.of(files)).drawing();
    };
  }

  /** Of each format one, small. */
  private static List<Map<String, byte[]>> correct() throws IOException {
    BitSet occupied = new BitSet();
    occupied.set(3, 7);
    OccupancyGrid walls = new OccupancyGrid(6, 5, 0.5, new Vec2(-1, 2), occupied);
    Area area = new Area(new Vec2(-1, 2), 0.5, 0.5);
    FloorDrawing drawing =
        new FloorDrawing(
            walls,
            List.of(new Place("Dock \"A\"", walls.centre(new Cell(1, 4)), 1.0, Direction.NORTH)),
            List.of(new Place("P", walls.centre(new Cell(2, 4)))),
            List.of(),
            List.of(area),
            List.of(new SpeedLimit(area, 0.3)),
            List.of(new OneWay(area, Direction.WEST)),
            Moves.SMOOTH);
    FloorMap floor = new FloorMap("m", drawing, Margins.USUAL);
    MapArchive archive = FloorWriter.mapServerFiles("m", drawing);
    Map<String, byte[]> ros = new LinkedHashMap<>();
    for (String name : List.of("m.yaml", "m.pgm", "m.floor.yaml")) {
      ros.put(name, Objects.requireNonNull(archive.content(name)));
    }
    Map<String, byte[]> withPng = new LinkedHashMap<>();
    String yaml =
        text(Objects.requireNonNull(ros.get("m.yaml")))
            .replace("m.pgm", "m.png")
            .replace("0]", "0.7]");
    withPng.put("m.yaml", yaml.getBytes(StandardCharsets.UTF_8));
    withPng.put("m.png", png(BufferedImage.TYPE_BYTE_GRAY));
    Map<String, byte[]> plain = new LinkedHashMap<>(ros);
    plain.put("m.pgm", "P2\n# x\n2 2\n255\n0 254\n254 0\n".getBytes(StandardCharsets.UTF_8));
    plain.remove("m.floor.yaml");
    return List.of(
        ros,
        withPng,
        plain,
        Map.of("map.zip", archive.pack()),
        Map.of("plan.png", png(BufferedImage.TYPE_4BYTE_ABGR)),
        Map.of("plan.png", png(BufferedImage.TYPE_BYTE_INDEXED)),
        Map.of("m.map", FloorWriter.movingAi(floor)));
  }

  private static String text(byte[] bytes) {
    return new String(bytes, StandardCharsets.UTF_8);
  }

  private static byte[] png(int type) throws IOException {
    BufferedImage image = new BufferedImage(5, 4, type);
    image.createGraphics().fillRect(1, 1, 3, 2);
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    ImageIO.write(image, "png", out);
    return out.toByteArray();
  }

  private Map<String, byte[]> mutated(Map<String, byte[]> files) {
    List<String> names = new ArrayList<>(files.keySet());
    String changed = names.get(random.nextInt(names.size()));
    Map<String, byte[]> others = new LinkedHashMap<>();
    for (String name : names) {
      byte[] content = Objects.requireNonNull(files.get(name));
      others.put(name, name.equals(changed) ? mutated(name, content) : content);
    }
    return others;
  }

  private byte[] mutated(String name, byte[] content) {
    byte[] bytes = content;
    for (int i = random.nextInt(3); i >= 0; i--) {
      int from = random.nextInt(bytes.length + 1);
      int to = Math.min(bytes.length, from + random.nextInt(8));
      bytes =
          switch (random.nextInt(6)) {
            case 0 -> Splice.of(bytes, from, new byte[0], to); // lost
            case 1 -> Splice.of(bytes, from, noise(to - from), to); // changed
            case 2 -> Splice.of(bytes, from, word(), to); // another word
            case 3 -> Splice.of(bytes, to, Arrays.copyOfRange(bytes, from, to), to); // twice
            case 4 -> withOtherBit(bytes);
            default ->
                random.nextInt(8) == 0 ? Splice.of(bytes, from, new byte[0], bytes.length) : bytes;
          };
    }
    return name.endsWith(".png") && random.nextBoolean() ? withChecksums(bytes) : bytes;
  }

  private byte[] withOtherBit(byte[] bytes) {
    byte[] other = bytes.clone();
    if (other.length > 0) {
      other[random.nextInt(other.length)] ^= (byte) (1 << random.nextInt(8));
    }
    return other;
  }

  private byte[] word() {
    return WORDS.get(random.nextInt(WORDS.size())).getBytes(StandardCharsets.UTF_8);
  }

  private byte[] noise(int length) {
    byte[] bytes = new byte[length];
    random.nextBytes(bytes);
    return bytes;
  }

  /** Else the decoder would stop at the first chunk. */
  private static byte[] withChecksums(byte[] png) {
    byte[] bytes = png.clone();
    for (int at = 8; at + 12 <= bytes.length; ) {
      int length = number(bytes, at);
      if (length < 0 || length > bytes.length - at - 12) {
        return bytes;
      }
      CRC32 checksum = new CRC32();
      checksum.update(bytes, at + 4, length + 4);
      for (int i = 0; i < 4; i++) {
        bytes[at + 8 + length + i] = (byte) (checksum.getValue() >> (24 - 8 * i));
      }
      at += 12 + length;
    }
    return bytes;
  }

  private static int number(byte[] bytes, int at) {
    return ByteBuffer.wrap(bytes, at, 4).getInt();
  }
}
