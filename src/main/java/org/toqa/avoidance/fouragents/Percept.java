package org.toqa.avoidance.fouragents;

import java.util.List;

/**
 * What the perception agent tells the others.
 *
 * @param ranges metres from the rim to anything, one a sensor of {@link RangeRing}
 * @param unknown the same, but as if nothing were there where a known obstacle explains the reading
 */
record Percept(List<Double> ranges, List<Double> unknown) {}
