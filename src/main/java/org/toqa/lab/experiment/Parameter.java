package org.toqa.lab.experiment;

/**
 * A number that the paper leaves open.
 *
 * @param name by which it is set: lower-case words with hyphens
 * @param value unless it is set
 * @param least the smallest that makes sense
 * @param most the largest that makes sense
 * @param unit such as {@code m/s}; empty for a plain number
 * @param meaning what it is, for a person
 */
public record Parameter(
    String name, double value, double least, double most, String unit, String meaning) {

  /**
   * @throws IllegalArgumentException if the value is out of the range
   */
  public Parameter {
    if (!(value >= least && value <= most)) {
      throw new IllegalArgumentException(
          "The parameter %s is %s, out of %s to %s.".formatted(name, value, least, most));
    }
  }

  /** Whether it may be set to that. */
  public boolean allows(double other) {
    return other >= least && other <= most;
  }
}
