package org.toqa.traffic.floor;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.Segment;
import org.toqa.motion.Trajectory;

/**
 * A robot's way in stretches. The last part of it may come from a plan for all robots; then it
 * knows the cells that it visits, and for each visit who must have left the cell before.
 *
 * @param start where it begins, map frame
 * @param stretches in order
 * @param base how many stretches come from earlier plans and were released then
 * @param lattice whose cells the visits are
 * @param visits the cells visited from {@code base} on, the first being where that part begins;
 *     empty for a way that meets nobody's
 * @param visitAfter by stretch from {@code base} on: the index of the visit at its end
 * @param waits by visit: who was there before, or null
 */
record Course(
    Pose start,
    List<Stretch> stretches,
    int base,
    @Nullable OccupancyGrid lattice,
    List<Cell> visits,
    List<Integer> visitAfter,
    List<@Nullable Wait> waits) {

  /** Another robot must have gone on from the visit of that index on that course of its. */
  record Wait(String robot, int course, int visit) {}

  Course {
    stretches = List.copyOf(stretches);
    visits = List.copyOf(visits);
    visitAfter = List.copyOf(visitAfter);
  }

  static Course meetingNobody(Pose start, List<Stretch> stretches) {
    return new Course(
        start, stretches, 0, null, List.of(), stretches.stream().map(s -> 0).toList(), List.of());
  }

  int size() {
    return stretches.size();
  }

  Trajectory trajectory() {
    return new Trajectory(start, segmentsFrom(0));
  }

  /** The segments of the stretches from {@code from} on. */
  List<Segment> segmentsFrom(int from) {
    List<Segment> segments = new ArrayList<>();
    stretches.subList(from, size()).forEach(s -> segments.addAll(s.segments()));
    return segments;
  }

  /** How many segments the first {@code count} stretches have. */
  int segmentsOf(int count) {
    return stretches.subList(0, count).stream().mapToInt(s -> s.segments().size()).sum();
  }

  /** How many stretches are complete when {@code segments} segments are. */
  int stretchesOf(int segments) {
    int left = segments;
    int count = 0;
    while (count < size() && stretches.get(count).segments().size() <= left) {
      left -= stretches.get(count++).segments().size();
    }
    return count;
  }

  /** Where the robot stands after the first {@code count} stretches. */
  Pose poseAfter(int count) {
    return count == 0 ? start : stretches.get(count - 1).end();
  }

  Pose end() {
    return poseAfter(size());
  }

  /** The index of the visit where the robot is after {@code count} stretches. */
  int visitAfterStretches(int count) {
    return count <= base ? 0 : visitAfter.get(count - base - 1);
  }

  /** Whether it may meet others' cells, in an order. */
  boolean isShared() {
    return !visits.isEmpty();
  }

  /** Its first {@code count} stretches, and then the whole of another course. */
  Course continued(int count, Course next) {
    List<Stretch> joined = new ArrayList<>(stretches.subList(0, count));
    joined.addAll(next.stretches);
    return new Course(start, joined, count, next.lattice, next.visits, next.visitAfter, next.waits);
  }

  Course withWaits(List<@Nullable Wait> others) {
    return new Course(start, stretches, base, lattice, visits, visitAfter, others);
  }

  /** The same visits in the same order, from stretch {@code count} on driven in other stretches. */
  Course redriven(int count, List<Stretch> others, List<Integer> othersVisits) {
    List<Stretch> joined = new ArrayList<>(stretches.subList(0, count));
    joined.addAll(others);
    List<Integer> joinedVisits = new ArrayList<>(visitAfter.subList(0, count - base));
    joinedVisits.addAll(othersVisits);
    return new Course(start, joined, base, lattice, visits, joinedVisits, waits);
  }
}
