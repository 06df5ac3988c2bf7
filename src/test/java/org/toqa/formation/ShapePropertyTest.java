package org.toqa.formation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;

class ShapePropertyTest {

  private static final double ROUNDING = 1e-9;

  @Property
  void robotsTouchNeitherTheLoadNorEachOther(
      @ForAll @IntRange(min = 2, max = 12) int robots,
      @ForAll @DoubleRange(min = 0.05, max = 3) double length,
      @ForAll @DoubleRange(min = 0.05, max = 3) double width,
      @ForAll @DoubleRange(min = 0.05, max = 0.5) double radius) {
    Shape shape = Shape.around(robots, length, width, radius);
    List<Vec2> places = new ArrayList<>(shape.followers());
    places.add(shape.leader());

    assertEquals(robots, places.size());
    for (int i = 0; i < robots; i++) {
      Vec2 place = places.get(i);
      double beside = Math.max(0, Math.abs(place.x()) - length / 2);
      double ahead = Math.max(0, Math.abs(place.y()) - width / 2);
      assertTrue(Math.hypot(beside, ahead) >= radius, "it is in the load: " + place);
      for (Vec2 other : places.subList(0, i)) {
        assertTrue(place.distanceTo(other) >= 2 * radius, place + " touches " + other);
      }
    }
  }

  @Property
  void loadIsWhereTheLeaderCarriesIt(
      @ForAll @IntRange(min = 2, max = 12) int robots,
      @ForAll @DoubleRange(min = -5, max = 5) double x,
      @ForAll @DoubleRange(min = -3, max = 3) double theta) {
    Shape shape = Shape.around(robots, 0.6, 0.4, 0.1275);
    Pose load = new Pose(x, 2, theta);
    Pose leader = shape.leaderAt(load);

    assertEquals(0, load.distanceTo(shape.loadAt(leader)), ROUNDING);
    List<Pose> followers = shape.followersAt(leader);
    for (int i = 0; i < followers.size(); i++) {
      Vec2 inLoad = load.relative(followers.get(i)).position();
      assertEquals(0, inLoad.distanceTo(shape.followers().get(i)), ROUNDING);
    }
  }

  @Example
  void twoStandInLineWithTheLoadBetweenThem() {
    Shape line = Shape.around(2, 0.6, 0.4, 0.1);

    // 0.3 m of load, 0.1 m of robot, 0.02 m of air
    assertEquals(0.42, line.leader().x(), ROUNDING);
    assertEquals(-0.84, line.offsets().getFirst().x(), ROUNDING);
    assertEquals(0, line.offsets().getFirst().y(), ROUNDING);
    assertEquals(0.2, line.smallestRadius(), ROUNDING);
  }

  @Example
  void threeStandInATriangleLeaderInFront() {
    Shape triangle = Shape.around(3, 0.6, 0.8, 0.1);

    // half the load's diagonal 0.5 m, 0.1 m of robot, 0.02 m of air
    double ring = 0.62;
    assertEquals(-1.5 * ring, triangle.offsets().getFirst().x(), ROUNDING);
    assertEquals(Math.sqrt(3) / 2 * ring, triangle.offsets().getFirst().y(), ROUNDING);
    assertEquals(Math.sqrt(3) * ring, triangle.reach(), ROUNDING);
    assertEquals(Math.sqrt(3) / 2 * ring + 0.2, triangle.smallestRadius(), ROUNDING);
  }

  @Example
  void sizesThatNoLoadHasAreRefused() {
    assertThrows(IllegalArgumentException.class, () -> Shape.around(1, 0.5, 0.5, 0.1));
    assertThrows(IllegalArgumentException.class, () -> Shape.around(13, 0.5, 0.5, 0.1));
    assertThrows(IllegalArgumentException.class, () -> Shape.around(3, 0, 0.5, 0.1));
    assertThrows(IllegalArgumentException.class, () -> Shape.around(3, 0.5, Double.NaN, 0.1));
  }
}
