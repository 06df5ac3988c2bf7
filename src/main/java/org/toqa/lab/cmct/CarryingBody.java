package org.toqa.lab.cmct;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Map;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;

/**
 * A simulated robot: it goes from the middle of a cell to that of the next one, and stops there.
 */
final class CarryingBody {
  static final double RADIUS = 0.5;

  /** What it is about. */
  enum Errand {
    NONE,
    SEARCH,
    /** Makes out a box that it sees. */
    LOOK,
    TO_BOX,
    WEIGH,
    /** Beside a heavy box. */
    WAIT,
    TO_HELP,
    CARRY,
    SET_DOWN,
    TO_STATION,
    CHARGE,
    PARK
  }

  final String name;
  final Vec2 parking;
  final Deque<Vec2> path = new ArrayDeque<>();

  final @Nullable SeenMap seen;

  /** Seconds for which boxes were in view that it has not made out. */
  final Map<Integer, Double> glimpsed = new TreeMap<>();

  Vec2 position;

  /** Where it was when its cameras looked last. */
  @Nullable Vec2 lookedFrom;

  Errand errand = Errand.NONE;
  int about;
  boolean isAlive = true;
  double battery = 1;
  double work;
  double driven;

  /** Seconds until what it does where it stands is done. */
  double busy;

  /** Whether it drives aside for others, and then seconds until it goes on. */
  boolean makesRoom;

  double pause;

  /** When it plans again, after it found no path; seconds. */
  double retry;

  /** What it does when it has made out a box. */
  Errand afterLook = Errand.NONE;

  @Nullable Vec2 goal;
  @Nullable Integer held;
  @Nullable CarryingBody partner;

  /** Of two that carry together: whether its path is that of both. */
  boolean leads;

  /** From the box to the first side of two that carry together, metres. */
  Vec2 side = Vec2.ZERO;

  CarryingBody(String name, Vec2 parking, @Nullable SeenMap seen) {
    this.name = name;
    this.parking = parking;
    this.seen = seen;
    position = parking;
  }

  boolean isDriving() {
    CarryingBody other = partner;
    return isAlive && (!path.isEmpty() || (other != null && !other.path.isEmpty()));
  }

  void begin(Errand next, int box) {
    errand = next;
    about = box;
    busy = 0;
    halt();
  }

  /** Goes no further than to the middle of the next cell. */
  void halt() {
    Vec2 next = isInMiddle() ? null : path.peekFirst();
    path.clear();
    if (next != null) {
      path.add(next);
    }
    goal = null;
    makesRoom = false;
    retry = 0;
  }

  boolean isInMiddle() {
    return position.x() - Math.floor(position.x()) == 0.5
        && position.y() - Math.floor(position.y()) == 0.5;
  }

  /** Where it stands, or will when it has come to the middle of the next cell. */
  Vec2 next() {
    Vec2 next = isInMiddle() ? null : path.peekFirst();
    return next == null ? position : next;
  }

  void begin(Errand next) {
    begin(next, 0);
  }

  /** Goes on along its path; whether it has come to its end. */
  boolean drive(double metres, boolean mayGoOn) {
    double left = metres;
    while (!path.isEmpty() && left > 0) {
      Vec2 next = path.getFirst();
      if (isInMiddle() && !mayGoOn) {
        return false;
      }
      double distance = position.distanceTo(next);
      if (distance <= left) {
        move(next);
        path.removeFirst();
        left -= distance;
      } else {
        move(position.plus(next.minus(position).times(left / distance)));
        left = 0;
      }
    }
    return path.isEmpty();
  }

  private void move(Vec2 to) {
    CarryingBody other = partner;
    driven += position.distanceTo(to);
    if (other != null) {
      other.driven += position.distanceTo(to);
      other.position = to.minus(side.times(2));
    }
    position = to;
  }
}
