package org.toqa.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.OptionalDouble;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.toqa.agent.chassis.SharedLoad;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;

/** A load of 12 kg whose middle is at (5, 5), and robots that hold it 0.3 m ahead of them. */
class CarriedLoadsTest {
  private static final double EXACT = 1e-9;
  private static final Vec2 AHEAD = new Vec2(0.3, 0);

  private final CarriedLoads loads = new CarriedLoads();

  @Test
  void nobodyBearsAnythingUntilAllAreUnderTheLoad() {
    tick(8, new Pose(4.6, 5, 0), null); // holds it at x 4.9
    tick(8, new Pose(4.6, 5, 0), null);
    assertEquals(OptionalDouble.empty(), loads.shareOf("a"));
    tick(8, new Pose(4.6, 5, 0), new Pose(5.5, 5, Math.PI)); // at x 5.2: twice as far out
    assertShares(8, 4);
    loads.put("b", null, new Pose(5.5, 5, Math.PI));
    assertEquals(OptionalDouble.empty(), loads.shareOf("a"));
  }

  @Test
  void robotThatStandsFartherOutBearsLess() {
    tick(6, new Pose(4.5, 5, 0), new Pose(5.6, 5, Math.PI)); // at x 4.8 and x 5.3, not 5.2
    assertShares(7.2, 4.8); // 0.3 / 0.5 of 12 kg
  }

  /** The load goes along and turns with them, and weighs on them as before. */
  @Test
  void robotsThatKeepTheirPlacesKeepTheirShares() {
    tick(8, new Pose(4.6, 5, 0), new Pose(5.5, 5, Math.PI));
    // turned by a quarter round (0, 0): (x, y) is (-y, x)
    tick(8, new Pose(-5, 4.6, Math.PI / 2), new Pose(-5, 5.5, -Math.PI / 2));
    assertShares(8, 4);
  }

  /** It slips as far on the one as on the other. */
  @Test
  void robotsWithTheSameShareThatComeNearerKeepIt() {
    tick(6, new Pose(4.5, 5, 0), new Pose(5.5, 5, Math.PI));
    tick(6, new Pose(4.5, 5, 0), new Pose(5.4, 5, Math.PI));
    assertShares(6, 6);
  }

  /** Of four one may be off the floor; and what two in a row cannot balance, they carry evenly. */
  @Test
  void supportsAreAsStiffAsTheSharesTheyAreSetFor() {
    List<Vec2> square =
        List.of(new Vec2(0.2, 0.2), new Vec2(-0.2, 0.2), new Vec2(-0.2, -0.2), new Vec2(0.2, -0.2));
    assertForces(List.of(5.0, 1.0, 5.0, 1.0), square, List.of(5.0, 1.0, 5.0, 1.0));

    // 3 (1 + b x) with b = -12 * 0.05 / (4 * 3 * 0.04) = -1.25
    List<Vec2> aside = square.stream().map(p -> p.plus(new Vec2(0.05, 0))).toList();
    assertForces(List.of(2.25, 3.75, 3.75, 2.25), aside, List.of(3.0, 3.0, 3.0, 3.0));

    // the middle is beyond all of them: the nearest bears it
    assertForces(
        List.of(12.0, 0.0), List.of(new Vec2(0.1, 0), new Vec2(0.3, 0)), List.of(6.0, 6.0));

    // beside their line
    assertForces(List.of(6.0, 6.0), List.of(new Vec2(-1, 1), new Vec2(1, 1)), List.of(6.0, 6.0));
  }

  private static void assertForces(List<Double> forces, List<Vec2> points, List<Double> planned) {
    double[] borne = SupportForces.of(points, planned, 12);
    for (int i = 0; i < borne.length; i++) {
      assertEquals(forces.get(i), borne[i], EXACT, "support " + i);
    }
  }

  /** All that is told at one moment counts when the next one begins. */
  private void tick(double shareOfA, Pose ofA, @Nullable Pose ofB) {
    for (int i = 0; i < 2; i++) {
      loads.put("a", part(shareOfA), ofA);
      if (ofB != null) {
        loads.put("b", part(12 - shareOfA), ofB);
      }
    }
    loads.put("a", part(shareOfA), ofA);
  }

  private static SharedLoad part(double share) {
    return new SharedLoad(7, share, 12, AHEAD, new Vec2(5, 5));
  }

  private void assertShares(double ofA, double ofB) {
    assertEquals(ofA, loads.shareOf("a").orElseThrow(), EXACT);
    assertEquals(ofB, loads.shareOf("b").orElseThrow(), EXACT);
  }
}
