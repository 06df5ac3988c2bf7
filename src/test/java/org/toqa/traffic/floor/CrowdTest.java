package org.toqa.traffic.floor;

import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** A {@link Crowd} that got nowhere. */
class CrowdTest {

  /** All were led to and fro between lanes of two widths, on account of a large one. */
  @Test
  void robotsOfTwoSizesAreNotLedToAndFro() {
    assertTrue(Crowd.drive(2, 24));
  }
}
