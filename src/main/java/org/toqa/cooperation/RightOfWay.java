package org.toqa.cooperation;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;

/**
 * Who moves where robots have come closer than {@code D_s}: all of them stand, then one after the
 * other goes on by a new path round those that stand. The published rule says no more than that
 * both stop and get new paths; here the one that carries goes first, then the one with the smaller
 * name.
 *
 * @param standing robots that may not drive
 * @param passing the one of them that drives past the others
 * @param tried those that have no path past the others where they stand now
 * @param aside the one that makes room, when none of them has a path
 */
public record RightOfWay(
    Set<String> standing, @Nullable String passing, Set<String> tried, @Nullable String aside) {

  /** Nobody is close to anybody. */
  public static final RightOfWay CLEAR = new RightOfWay(Set.of(), null, Set.of(), null);

  /**
   * A robot on the floor.
   *
   * @param position metres, map frame
   * @param isDriving whether it has a way to go, though it may be standing for others
   * @param isCarrying whether it has a box
   * @param partner with whom it carries: the two are no danger to each other
   */
  public record Place(
      String robot,
      Vec2 position,
      boolean isDriving,
      boolean isCarrying,
      @Nullable String partner) {}

  public RightOfWay {
    standing = new TreeSet<>(standing);
    tried = new TreeSet<>(tried);
  }

  /** Whether a robot may drive. */
  public boolean mayDrive(String robot) {
    return !standing.contains(robot) || robot.equals(passing);
  }

  /**
   * Looks at where all are.
   *
   * @param places of all robots; of two that carry together both drive
   * @param distance D_s, metres between middles
   */
  public RightOfWay next(List<Place> places, double distance) {
    Set<String> close = new TreeSet<>(standing);
    for (Place one : places) {
      for (Place other : places) {
        if (areClose(one, other, distance) && (one.isDriving() || other.isDriving())) {
          close.add(one.robot());
          close.add(other.robot());
        }
      }
    }
    // who is away from all the others, or has nowhere to go and nobody near that has, is out of it
    Set<String> near = new TreeSet<>();
    for (Place one : places) {
      for (Place other : places) {
        if (close.contains(one.robot())
            && areClose(one, other, distance)
            && (one.isDriving() || other.isDriving())) {
          near.add(one.robot());
          if (one.partner() != null) {
            near.add(one.partner());
          }
        }
      }
    }
    if (near.isEmpty()) {
      return CLEAR;
    }
    boolean isPassing =
        passing != null
            && near.contains(passing)
            && places.stream().anyMatch(p -> p.robot().equals(passing) && p.isDriving());
    if (isPassing) {
      return new RightOfWay(near, passing, tried, aside);
    }
    boolean hasMoved = passing != null;
    Set<String> still = hasMoved ? Set.of() : tried;
    Optional<Place> first =
        places.stream()
            .filter(p -> near.contains(p.robot()) && p.isDriving() && !still.contains(p.robot()))
            .min(
                Comparator.comparing((Place p) -> !p.isCarrying())
                    .thenComparing(p -> p.robot().equals(aside))
                    .thenComparing(Place::robot));
    return new RightOfWay(near, first.map(Place::robot).orElse(null), still, null);
  }

  /** The one that should pass has no path past the others. */
  public RightOfWay blocked() {
    if (passing == null) {
      return this;
    }
    Set<String> more = new TreeSet<>(tried);
    more.add(passing);
    return new RightOfWay(standing, null, more, null);
  }

  /** None has a path: one of them drives aside, where the others have not tried. */
  public RightOfWay makesRoom(String robot) {
    return new RightOfWay(standing, robot, Set.of(), robot);
  }

  private static boolean areClose(Place one, Place other, double distance) {
    return !one.robot().equals(other.robot())
        && !other.robot().equals(one.partner())
        && one.position().distanceTo(other.position()) < distance;
  }
}
