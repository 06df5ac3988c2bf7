package org.toqa.cooperation;

import java.util.Set;
import java.util.TreeSet;
import org.toqa.geometry.Vec2;

/**
 * A box that was seen.
 *
 * @param seenBy robots whose cameras saw it
 * @param place where it was seen last, metres, map frame
 * @param isHeavy whether it was weighed and needs two workers
 */
public record KnownBox(Stage stage, Set<String> seenBy, Vec2 place, boolean isHeavy) {

  public KnownBox {
    seenBy = Set.copyOf(seenBy);
  }

  /** How far it is. */
  public enum Stage {
    /** Nobody has been sent for it. */
    FOUND,
    /** The map has no path to it, or on to its target, yet. */
    UNREACHABLE,
    /** A worker drives to it. */
    ALLOCATED,
    /** A worker waits beside it for a second one. */
    NEEDS_SECOND,
    CARRIED,
    /** The worker that carried it is lost: where it lies must be seen first. */
    MISSING,
    DELIVERED
  }

  KnownBox at(Stage next) {
    return new KnownBox(next, seenBy, place, isHeavy);
  }

  KnownBox at(Stage next, Vec2 there) {
    return new KnownBox(next, seenBy, there, isHeavy);
  }

  KnownBox weighedHeavy() {
    return new KnownBox(Stage.NEEDS_SECOND, seenBy, place, true);
  }

  KnownBox alsoSeenBy(String robot) {
    Set<String> more = new TreeSet<>(seenBy);
    more.add(robot);
    return new KnownBox(stage, more, place, isHeavy);
  }
}
