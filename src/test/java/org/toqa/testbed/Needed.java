package org.toqa.testbed;

import static org.junit.jupiter.api.Assertions.fail;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

/**
 * What a machine may lack. There a test is left out, with a word; but {@code ./toqa test} leaves
 * out nothing ({@code -Dtoqa.full=true}): it fails, and says what is missing.
 */
public final class Needed {
  private static final boolean IS_FULL = Boolean.getBoolean("toqa.full");

  private Needed() {}

  /**
   * @param missing what it is, and how to get it
   */
  public static void orLeftOut(boolean isThere, String missing) {
    if (IS_FULL && !isThere) {
      fail("./toqa test leaves out nothing, but here is missing: " + missing);
    }
    assumeTrue(isThere, missing);
  }
}
