package org.toqa.traffic.floor;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.grid.Cell;
import org.toqa.motion.Segment;
import org.toqa.motion.Trajectory;

/**
 * A robot's path in sections. The last part of it may come from a plan for all robots; then it
 * knows the cells that it visits, and for each visit who must have left the cell before.
 *
 * @param start where it begins, map frame
 * @param sections in order
 * @param inherited how many sections come from earlier plans and were released then
 * @param lanes whose cells the visits are
 * @param visits the cells visited from {@code inherited} on, the first being where that part
 *     begins; empty for a path that meets nobody's
 * @param visitAtEnd by section from {@code inherited} on: the index of the visit at its end
 * @param dependencies by visit: who was there, or too near to it, before
 */
record ReservedPath(
    Pose start,
    List<Section> sections,
    int inherited,
    @Nullable LanePoints lanes,
    List<Cell> visits,
    List<Integer> visitAtEnd,
    List<List<Dependency>> dependencies) {

  /** Another robot must have gone on from the visit of that index on that path of its. */
  record Dependency(String robot, int pathNumber, int visit) {}

  ReservedPath {
    sections = List.copyOf(sections);
    visits = List.copyOf(visits);
    visitAtEnd = List.copyOf(visitAtEnd);
  }

  static ReservedPath independent(Pose start, List<Section> sections) {
    return new ReservedPath(
        start, sections, 0, null, List.of(), sections.stream().map(s -> 0).toList(), List.of());
  }

  int sectionCount() {
    return sections.size();
  }

  Trajectory trajectory() {
    return new Trajectory(start, segmentsFrom(0));
  }

  /** The segments of the sections from {@code from} on. */
  List<Segment> segmentsFrom(int from) {
    List<Segment> segments = new ArrayList<>();
    sections.subList(from, sectionCount()).forEach(s -> segments.addAll(s.segments()));
    return segments;
  }

  /** How many segments the first {@code count} sections have. */
  int segmentCount(int count) {
    int segments = 0;
    for (int i = 0; i < count; i++) {
      segments += sections.get(i).segments().size();
    }
    return segments;
  }

  /** How many sections are complete when {@code segments} segments are. */
  int completedSections(int segments) {
    int left = segments;
    int count = 0;
    while (count < sectionCount() && sections.get(count).segments().size() <= left) {
      left -= sections.get(count++).segments().size();
    }
    return count;
  }

  /** After how many sections a robot that may drive the first {@code count} is in a cell again. */
  int committed(int count) {
    int end = count;
    while (end > 0 && end < sectionCount() && sections.get(end - 1).endsHalfway()) {
      end++;
    }
    return end;
  }

  /** Where the robot is after the first {@code count} sections. */
  Pose poseAfter(int count) {
    return count == 0 ? start : sections.get(count - 1).end();
  }

  Pose end() {
    return poseAfter(sectionCount());
  }

  /** The index of the visit where the robot is after {@code count} sections. */
  int visitAfterSections(int count) {
    return count <= inherited ? 0 : visitAtEnd.get(count - inherited - 1);
  }

  /** Whether it may meet others' cells, in an order. */
  boolean isShared() {
    return !visits.isEmpty();
  }

  /** Its first {@code count} sections, and then the whole of another path. */
  ReservedPath continuedWith(int count, ReservedPath next) {
    return continuedWith(count, next, 0);
  }

  /**
   * Its first {@code count} sections, and then the rest of another path, whose first {@code along}
   * are driven as the last of these.
   */
  ReservedPath continuedWith(int count, ReservedPath next, int along) {
    List<Section> joined = new ArrayList<>(sections.subList(0, count));
    if (next.inherited == 0 && along == 0 && count > 0) {
      joined.set(count - 1, joined.getLast().asLast());
    }
    joined.addAll(next.sections.subList(along, next.sectionCount()));
    return new ReservedPath(
        start,
        joined,
        count - along + next.inherited,
        next.lanes,
        next.visits,
        next.visitAtEnd,
        next.dependencies);
  }

  /**
   * What of it comes behind its first {@code count} sections, of which none was planned with it.
   */
  ReservedPath from(int count) {
    return new ReservedPath(
        poseAfter(count),
        sections.subList(count, sectionCount()),
        inherited - count,
        lanes,
        visits,
        visitAtEnd,
        dependencies);
  }

  ReservedPath withDependencies(List<List<Dependency>> others) {
    return new ReservedPath(start, sections, inherited, lanes, visits, visitAtEnd, others);
  }

  /** The same visits in the same order, from section {@code count} on driven in other sections. */
  ReservedPath withSectionsFrom(int count, List<Section> newSections, List<Integer> newVisits) {
    List<Section> joined = new ArrayList<>(sections.subList(0, count));
    joined.addAll(newSections);
    List<Integer> joinedVisits = new ArrayList<>(visitAtEnd.subList(0, count - inherited));
    joinedVisits.addAll(newVisits);
    return new ReservedPath(start, joined, inherited, lanes, visits, joinedVisits, dependencies);
  }
}
