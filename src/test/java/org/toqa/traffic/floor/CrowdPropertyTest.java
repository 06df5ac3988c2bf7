package org.toqa.traffic.floor;

import static org.junit.jupiter.api.Assertions.assertTrue;

import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.LongRange;
import net.jqwik.api.lifecycle.AfterProperty;
import org.toqa.testbed.Cases;

/** A {@link Crowd} of a few robots. */
class CrowdPropertyTest {
  private static final int ROBOTS = 8;

  private final Cases floors = new Cases("generated floors");

  @Property(tries = 1, seed = "20261126")
  void inACrowdNothingTouchesAndEachArrivesOrSaysWhyNot(@ForAll @LongRange(min = 0) long seed) {
    floors.count(Crowd.drive(seed, ROBOTS));
  }

  /**
   * Others were led to and fro between lanes of two widths, on account of one that gets nowhere.
   */
  @Example
  void robotsOfTwoSizesAreNotLedToAndFro() {
    assertTrue(Crowd.drive(2, 24));
  }

  @AfterProperty
  void floorsHadRoomForRobots() {
    floors.assertPossible(0.9);
  }
}
