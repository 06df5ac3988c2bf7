package org.toqa.formation.swarm;

/** Which observers see an obstacle; one that there is not sees none. */
public record Sightings(boolean left, boolean middle, boolean right) {

  /** Whether any of them sees something. */
  public boolean any() {
    return left || middle || right;
  }
}
