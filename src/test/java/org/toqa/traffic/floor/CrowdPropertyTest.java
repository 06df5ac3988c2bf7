package org.toqa.traffic.floor;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Tag;
import net.jqwik.api.constraints.LongRange;
import net.jqwik.api.lifecycle.AfterProperty;
import org.toqa.testbed.Cases;

/** A {@link Crowd} of a few robots. */
@Tag("full")
class CrowdPropertyTest {
  private static final int ROBOTS = 8;

  private final Cases floors = new Cases("generated floors");

  @Property(tries = 1, seed = "20261126")
  void inACrowdNothingTouchesAndEachArrivesOrSaysWhyNot(@ForAll @LongRange(min = 0) long seed) {
    floors.count(Crowd.drive(seed, ROBOTS));
  }

  @AfterProperty
  void floorsHadRoomForRobots() {
    floors.assertPossible(0.9);
  }
}
