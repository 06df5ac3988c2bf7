package org.toqa.localisation;

import java.util.List;
import java.util.Optional;

/** Where ranges of one robot come from that were measured apart from its wheels. */
@FunctionalInterface
public interface RangeSource {

  /** For robots that publish none. */
  RangeSource NONE = Optional::empty;

  /**
   * What was measured at once.
   *
   * @param metres from the robot's rim
   * @param angles radians, counter-clockwise from straight ahead; as many
   * @param walls of the floor that the robot is on
   */
  record Measured(List<Double> metres, List<Double> angles, Walls walls) {}

  /** The newest that was heard within the last moment and not been taken yet; does not wait. */
  Optional<Measured> take();
}
