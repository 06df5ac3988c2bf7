package org.toqa.grid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Angles;
import org.toqa.geometry.Vec2;

/** What is written of a floor is read as it was, in both formats. */
class FloorFilesPropertyTest {
  private static final List<String> NAMES =
      List.of(
          "Dock A",
          "Say \"yes\"",
          "back\\slash",
          "'",
          "🤖🏭",
          "المحطة ١",
          "- x: 1",
          "# no",
          "{a: b}",
          "null",
          "1e3",
          "true",
          "~",
          "a: b",
          "\u0645\u06cc\u200c\u062e",
          "%YAML",
          "Level 1.floor",
          "X.FLOOR",
          "a.yaml",
          "b.map",
          "c.floor.yaml",
          "é".repeat(64));

  @Property(tries = 300)
  void aFloorIsReadAsItWasWritten(
      @ForAll long seed,
      @ForAll @IntRange(min = 2, max = 30) int width,
      @ForAll @IntRange(min = 2, max = 30) int height)
      throws MapFormatException {
    FloorMap floor = floor(new Random(seed), width, height);

    FloorMap read =
        FloorReader.read(
            MapArchive.unpack(FloorWriter.mapServerFiles(floor.name(), floor.drawing()).pack()));

    assertSame(floor.drawing(), read.drawing());
    assertEquals(FloorWriter.fileName(floor.name()), read.name());
  }

  /** As an older release let them be. */
  @Example
  void aStoredFloorIsReadThoughItsPlacesMayNotBeCalledSoAnyMore() throws MapFormatException {
    List<Place> stations =
        List.of(
            new Place("\u200f\u0645\u062d\u0637\u0629", new Vec2(0.5, 0.5)),
            new Place("x\u2028y", new Vec2(1.5, 0.5)));
    FloorDrawing drawing =
        new FloorDrawing(
            new OccupancyGrid(2, 1, 1, new Vec2(0, 0), new BitSet()),
            stations,
            List.of(),
            List.of(),
            List.of(),
            List.of(),
            List.of());
    MapArchive stored = MapArchive.unpack(FloorWriter.mapServerFiles("hall", drawing).pack());

    assertSame(drawing, FloorReader.readStored(stored));
    assertThrows(MapFormatException.class, () -> FloorReader.read(stored));
  }

  /** As many places and areas as are allowed, with the longest names. */
  @Example
  void theLargestDrawingThatIsAcceptedIsReadAsItWasStored() throws MapFormatException {
    OccupancyGrid walls = new OccupancyGrid(2, 1, 1, Vec2.ZERO, new BitSet());
    List<List<Place>> places = new ArrayList<>();
    for (int kind = 0; kind < 3; kind++) {
      List<Place> ofAKind = new ArrayList<>();
      for (int i = 0; i < FloorLimits.MOST_OF_A_KIND; i++) {
        String name = "%d%04d".formatted(kind, i) + "🤖".repeat(FloorLimits.LONGEST_NAME - 5);
        assertTrue(FloorLimits.isName(name), name);
        ofAKind.add(new Place(name, new Vec2(Math.PI / 3, -Math.E), 1 / 3.0, Direction.NORTH));
      }
      places.add(ofAKind);
    }
    Area area = new Area(new Vec2(-12_345.678901234567, 1 / 3.0), 1 / 7.0, 1 / 9.0);
    FloorDrawing drawing =
        new FloorDrawing(
            walls,
            places.get(0),
            places.get(1),
            places.get(2),
            Collections.nCopies(FloorLimits.MOST_OF_A_KIND, area),
            Collections.nCopies(FloorLimits.MOST_OF_A_KIND, new SpeedLimit(area, 1 / 3.0)),
            Collections.nCopies(FloorLimits.MOST_OF_A_KIND, new OneWay(area, Direction.WEST)),
            Collections.nCopies(FloorLimits.MOST_OF_A_KIND, area),
            Moves.SMOOTH);

    assertSame(
        drawing,
        FloorReader.readStored(
            MapArchive.unpack(FloorWriter.mapServerFiles("hall", drawing).pack())));
  }

  @Property(tries = 100)
  void aMovingAiMapHasTheCellsThatRobotsDriveOn(
      @ForAll long seed,
      @ForAll @IntRange(min = 1, max = 30) int width,
      @ForAll @IntRange(min = 1, max = 30) int height)
      throws MapFormatException {
    FloorMap floor = floor(new Random(seed), width, height);

    FloorMap read =
        FloorReader.read(MapArchive.of(Map.of("floor.map", FloorWriter.movingAi(floor))));

    assertEquals(floor.grid().occupied(), read.grid().occupied());
    assertEquals(width, read.grid().width());
    assertEquals(height, read.grid().height());
  }

  /** Angles are written in degrees. */
  private static void assertSame(FloorDrawing wanted, FloorDrawing read) {
    assertEquals(wanted.walls(), read.walls());
    assertEquals(wanted.keepOut(), read.keepOut());
    assertEquals(wanted.speedLimits(), read.speedLimits());
    assertEquals(wanted.oneWay(), read.oneWay());
    assertEquals(wanted.freeZones(), read.freeZones());
    assertEquals(wanted.moves(), read.moves());
    List<Place> places = wanted.places().toList();
    List<Place> others = read.places().toList();
    assertEquals(wanted.stations().size(), read.stations().size());
    assertEquals(wanted.parking().size(), read.parking().size());
    assertEquals(places.size(), others.size());
    for (int i = 0; i < places.size(); i++) {
      assertEquals(places.get(i).name(), others.get(i).name());
      assertEquals(places.get(i).position(), others.get(i).position());
      assertEquals(places.get(i).approach(), others.get(i).approach());
      Double heading = places.get(i).heading();
      Double other = others.get(i).heading();
      assertEquals(heading == null, other == null);
      if (heading != null && other != null) {
        assertEquals(0, Angles.difference(heading, other), 1e-9);
      }
    }
  }

  private static FloorMap floor(Random random, int width, int height) {
    double resolution = List.of(0.05, 0.3, 1.0, 1 / 3.0, 0.001, 100.0).get(random.nextInt(6));
    Vec2 origin = new Vec2(random.nextGaussian() * 100, random.nextGaussian() * 1e-7);
    BitSet occupied = new BitSet();
    for (int i = 0; i < width * height; i++) {
      occupied.set(i, random.nextInt(3) == 0);
    }
    OccupancyGrid walls = new OccupancyGrid(width, height, resolution, origin, occupied);
    List<Area> keepOut = areas(random, walls);
    OccupancyGrid drivable =
        new FloorDrawing(walls, List.of(), List.of(), List.of(), keepOut, List.of(), List.of())
            .drivable();
    Set<String> names = new HashSet<>();
    FloorDrawing drawing =
        new FloorDrawing(
            walls,
            places(random, drivable, names),
            places(random, drivable, names),
            places(random, drivable, names),
            keepOut,
            areas(random, walls).stream()
                .map(area -> new SpeedLimit(area, 0.05 + 2.9 * random.nextDouble()))
                .toList(),
            areas(random, walls).stream().map(area -> new OneWay(area, direction(random))).toList(),
            areas(random, walls),
            random.nextBoolean() ? Moves.SMOOTH : Moves.HEADING);
    return new FloorMap(NAMES.get(random.nextInt(NAMES.size())), drawing, Margins.USUAL);
  }

  private static List<Area> areas(Random random, OccupancyGrid walls) {
    List<Area> areas = new ArrayList<>();
    for (int i = random.nextInt(3); i > 0; i--) {
      double size = walls.resolution() * walls.width();
      areas.add(
          new Area(
              walls.origin().plus(new Vec2(random.nextGaussian() * size, random.nextDouble())),
              Math.nextUp(random.nextDouble() * size),
              Math.nextUp(random.nextDouble() * size)));
    }
    return areas;
  }

  private static List<Place> places(Random random, OccupancyGrid drivable, Set<String> names) {
    List<Place> places = new ArrayList<>();
    for (int i = random.nextInt(6); i > 0; i--) {
      Cell cell = new Cell(random.nextInt(drivable.width()), random.nextInt(drivable.height()));
      String name = random.nextBoolean() ? NAMES.get(random.nextInt(NAMES.size())) : name(random);
      if (drivable.isFree(drivable.centre(cell)) && FloorLimits.isName(name) && names.add(name)) {
        @Nullable Double heading =
            random.nextBoolean() ? Angles.normalise(random.nextGaussian() * 3) : null;
        @Nullable Direction approach = random.nextBoolean() ? direction(random) : null;
        places.add(new Place(name, drivable.centre(cell), heading, approach));
      }
    }
    return places;
  }

  /** Of any letters that a text may have. */
  private static String name(Random random) {
    StringBuilder name = new StringBuilder();
    for (int i = random.nextInt(12); i >= 0; i--) {
      int letter = random.nextInt(4) == 0 ? random.nextInt(0x11_0000) : 32 + random.nextInt(224);
      name.appendCodePoint(letter >= 0xD800 && letter < 0xE000 ? '"' : letter);
    }
    byte[] bytes = name.toString().getBytes(StandardCharsets.UTF_8);
    return new String(bytes, StandardCharsets.UTF_8).strip();
  }

  private static Direction direction(Random random) {
    return Direction.values()[random.nextInt(4)];
  }
}
