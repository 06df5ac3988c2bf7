package org.toqa.app.bench.meter;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.time.Duration;
import java.util.List;
import java.util.Objects;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.sim.Body;
import org.toqa.sim.ClearanceJudge;

class ContactMeterTest {
  private static final double RADIUS = 0.1;

  @Test
  void eachTimeTwoComeToTouchIsOneContact() {
    ContactMeter meter = new ContactMeter(OccupancyGrid.parse("....", "...."), 2, RADIUS);
    meter.place(0, new Vec2(1, 1));
    meter.place(1, new Vec2(1.5, 1));
    meter.judge(1);
    assertEquals(0.3, metres(meter.nearest()), 1e-9); // 0.5 - 2 x 0.1

    for (double x : List.of(1.2, 1.19, 1.18, 1.3, 1.1)) {
      meter.place(1, new Vec2(x, 1));
      meter.judge(1);
      meter.judge(0);
    }

    assertEquals(2, meter.contacts());
    assertEquals(-0.1, metres(meter.nearest()), 1e-9);
    assertEquals(0, meter.wallContacts());
  }

  @Test
  void wallsAreOccupiedCellsAndTheEdge() {
    ContactMeter meter = new ContactMeter(OccupancyGrid.parse("...", ".@.", "..."), 1, RADIUS);
    meter.place(0, new Vec2(0.5, 0.5));
    meter.judge(0);
    assertEquals(0.4, metres(meter.nearestWall()), 1e-9); // the edge, 0.5 - 0.1

    meter.place(0, new Vec2(0.95, 0.95)); // sqrt(2) x 0.05 = 0.07 from the corner
    meter.judge(0);
    meter.place(0, new Vec2(0.96, 0.96));
    meter.judge(0);

    assertEquals(1, meter.wallContacts());
    assertNull(meter.nearest());
  }

  /** By other code, which looks at all pairs. */
  @Test
  void findsWhatTheJudgeOfClearancesFinds() {
    OccupancyGrid walls = OccupancyGrid.parse("......", ".@..@.", "......", "...@..", "......");
    SplittableRandom random = new SplittableRandom(1);
    int discs = 9;
    Vec2[] at = new Vec2[discs];
    ContactMeter meter = new ContactMeter(walls, discs, RADIUS);
    ClearanceJudge judge = new ClearanceJudge(walls);
    for (int moment = 0; moment < 300; moment++) {
      for (int disc = 0; disc < discs; disc++) {
        at[disc] = new Vec2(random.nextDouble(0, 6), random.nextDouble(0, 5));
        meter.place(disc, at[disc]);
      }
      IntStream.range(0, discs).forEach(meter::judge);
      judge.judge(
          Duration.ZERO,
          IntStream.range(0, discs)
              .mapToObj(disc -> Body.disc("r" + disc, at[disc], RADIUS))
              .toList());
      assertEquals(judge.betweenBodies().orElseThrow().metres(), metres(meter.nearest()), 1e-9);
      assertEquals(judge.toWall().orElseThrow().metres(), metres(meter.nearestWall()), 1e-9);
    }
  }

  private static double metres(@Nullable Double found) {
    return Objects.requireNonNull(found);
  }
}
