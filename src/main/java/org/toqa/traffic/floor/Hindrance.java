package org.toqa.traffic.floor;

import java.util.Locale;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;

/** Why a robot does not get on. */
public sealed interface Hindrance {

  /** For people; begins with a capital letter and ends without a full stop. */
  String sentence();

  /** The robot that it waits for, if it is one. */
  default @Nullable String robot() {
    return null;
  }

  /** Another robot has cells that it needs, and will leave them. */
  record Passing(String robot, Vec2 where) implements Hindrance {
    @Override
    public String sentence() {
      return "Waits for " + robot + " to pass at " + at(where);
    }
  }

  /** Another robot stands where it has to go. */
  record Standing(String robot, Vec2 where) implements Hindrance {
    @Override
    public String sentence() {
      return "Waits for " + robot + ", which stands in its way at " + at(where);
    }
  }

  /** Another robot stands there, and cannot be told to make room. */
  record Fixed(String robot, Vec2 where) implements Hindrance {
    @Override
    public String sentence() {
      return "Waits for "
          + robot
          + ", which stands in its way at "
          + at(where)
          + " and cannot be told to move";
    }
  }

  /** Another robot has its goal, or comes there first. */
  record PlaceTaken(String robot, Vec2 where) implements Hindrance {
    @Override
    public String sentence() {
      return "Waits for " + robot + " to leave its goal at " + at(where);
    }
  }

  /** Something that the map does not show stands in its only way. */
  record Obstacle(Vec2 where) implements Hindrance {
    @Override
    public String sentence() {
      return "Waits: an obstacle stands in its only way at " + at(where);
    }
  }

  /** The floor itself has no way for a robot of its size. */
  record NoWay(Vec2 goal, double diameter) implements Hindrance {
    @Override
    public String sentence() {
      return String.format(
          Locale.ROOT,
          "Waits: the map has no way to %s that is wide enough for its %.2f m",
          at(goal),
          diameter);
    }
  }

  /** No plan for all robots was found in the time there is; it is tried again. */
  record NoPlan(Vec2 goal) implements Hindrance {
    @Override
    public String sentence() {
      return "Waits: no way to "
          + at(goal)
          + " was found yet that all robots make room for; it is tried again";
    }
  }

  private static String at(Vec2 point) {
    return String.format(Locale.ROOT, "(%.2f, %.2f)", point.x(), point.y());
  }
}
