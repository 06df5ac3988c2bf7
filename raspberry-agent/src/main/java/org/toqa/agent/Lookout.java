package org.toqa.agent;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import org.toqa.avoidance.Corridor;
import org.toqa.avoidance.Glance;
import org.toqa.avoidance.Passage;
import org.toqa.avoidance.RangeSensors;
import org.toqa.avoidance.Sidestep;
import org.toqa.avoidance.Sightings;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage.Fault;

/**
 * Watches the way that a robot is about to drive: lets it step aside for what only reaches in,
 * stops it before what stands there, and has it look how wide that is. A leader only stops.
 */
final class Lookout {

  private static final Passage FREE = new Passage(List.of(), List.of(), Double.POSITIVE_INFINITY);

  /** Metres round a point that is in the way: what is seen there belongs to the same thing. */
  private static final double SAME_THING = 0.5;

  /** Metres; with less room than this it stands. */
  private static final double NO_ROOM = 0.02;

  private final double radius;
  private final RangeSensors sensors;
  private final Sightings inTheWay = new Sightings();
  private final Sightings near = new Sightings();
  private final Sidestep sidestep = new Sidestep();
  private final Glance glance = new Glance();
  private List<Vec2> fresh = List.of();
  private double now;
  private Passage passage = FREE;

  /**
   * @param radius of the robot, metres
   */
  Lookout(double radius) {
    this.radius = radius;
    this.sensors = new RangeSensors(radius);
  }

  /**
   * To be called first in every tick.
   *
   * @param ranges metres, in the order of the range sensors
   * @param pose where the robot is, map frame
   * @param seconds on a monotonic clock
   */
  void see(List<Double> ranges, Pose pose, double seconds) {
    now = seconds;
    inTheWay.forget(now);
    near.forget(now);
    fresh = sensors.sightings(ranges, pose);
    passage = FREE;
  }

  /**
   * Looks along the way, and slows it down before what stands there.
   *
   * @param seconds since the last call
   * @param onward whether the robot may move
   */
  void guide(Way way, double seconds, boolean onward) {
    List<Vec2> seen = seen();
    if (!seen.isEmpty() || !sidestep.isOnWay() || !glance.isStraight()) {
      Corridor corridor = look(way, seen);
      sidestep.step(way.pose(), way.twist().vx(), passage.beside(), corridor.length(), seconds);
      if (onward) {
        glance.step(isStopped() && way.stands(), seconds);
      } else {
        glance.rest();
      }
    }
    way.standWithin(glance.isStraight() ? passage.room() : 0);
  }

  /** The same for a leader, which has a load beside it: it neither steps aside nor turns. */
  void guideLeader(Way way) {
    List<Vec2> seen = seen();
    if (!seen.isEmpty()) {
      look(way, seen);
    }
    way.standWithin(passage.room());
  }

  private List<Vec2> seen() {
    return Stream.concat(inTheWay.points().stream(), fresh.stream()).toList();
  }

  private Corridor look(Way way, List<Vec2> seen) {
    Corridor corridor = new Corridor(way.ahead(RangeSensors.FARTHEST + 2 * radius));
    passage = Passage.through(corridor, seen, radius);
    remember();
    return corridor;
  }

  private void remember() {
    inTheWay.remember(fresh.stream().filter(passage::concerns).toList(), now);
    near.remember(fresh.stream().filter(this::isNear).toList(), now);
  }

  private boolean isNear(Vec2 point) {
    return passage.blocking().stream().anyMatch(p -> p.distanceTo(point) < SAME_THING);
  }

  private boolean isStopped() {
    return passage.room() < NO_ROOM;
  }

  /**
   * Where the robot shall be.
   *
   * @param onWay where it would be on its way, map frame
   */
  Pose corrected(Pose onWay) {
    return glance.turned(sidestep.beside(onWay));
  }

  /**
   * How the robot shall move, in its own frame.
   *
   * @param onWay how it would move on its way, in its own frame
   */
  Twist corrected(Twist onWay) {
    return glance.turned(sidestep.beside(onWay));
  }

  /** The points where something is in the way or belongs to that, map frame. */
  List<Vec2> obstacles() {
    return passage.blocking().isEmpty() ? List.of() : near.points();
  }

  /** What it stands before; empty where it does not. */
  Optional<Fault> fault() {
    return isStopped()
        ? Optional.of(
            new Fault(
                "OBSTACLE",
                String.format(
                    Locale.ROOT,
                    "Something stands %.2f m ahead; the robot waits until it is gone.",
                    passage.ahead())))
        : Optional.empty();
  }
}
