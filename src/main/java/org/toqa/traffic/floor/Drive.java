package org.toqa.traffic.floor;

import java.time.Instant;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.motion.Segment;

/** What a robot drives by: its reserved path, how far that is released, and what it was told. */
final class Drive {
  /** Metres; points nearer to each other are the same but for rounding. */
  private static final double SAME_POINT = 1e-6;

  private @Nullable ReservedPath path;

  /** Counts the paths, so that a wait for an earlier one counts as over. */
  private int pathNumber;

  /** Whether the robot was told to begin the path. */
  private boolean isBegun;

  /** So many sections the robot was told that it may drive. */
  private int sentReleased;

  /** Whether the robot does not know yet that its path goes on otherwise behind these. */
  private boolean isChangeUnsent;

  /** Sections of the path that are completed. */
  private int completed;

  /** Segments of the path that are completed. */
  private int completedSegments;

  /** Segments of the sections that are completed. */
  private int segmentsBefore;

  /** Sections of the path that it may drive. */
  private int released;

  /** When it last completed a section or was given one to drive. */
  private Instant lastProgress;

  /** How often what it may drive, or has still to drive of that, became another. */
  private long changes;

  /** What it was lent beside its path; null: nothing. */
  private @Nullable LentRoom lentRoom;

  /** Whether the robot does not know yet what it was lent. */
  private boolean isRoomUnsent;

  /** Where its last path ended, which it came to but for what a robot is off its place. */
  private @Nullable Pose lastPathEnd;

  /** Kept, since it is asked for at each tick; null: not asked for yet. */
  private RemainingPath.@Nullable Behind behindOpen;

  Drive(Instant now) {
    this.lastProgress = now;
  }

  /** Another one in the same state. */
  Drive copy() {
    Drive copy = new Drive(lastProgress);
    copy.path = path;
    copy.pathNumber = pathNumber;
    copy.isBegun = isBegun;
    copy.sentReleased = sentReleased;
    copy.isChangeUnsent = isChangeUnsent;
    copy.completed = completed;
    copy.segmentsBefore = segmentsBefore;
    copy.completedSegments = completedSegments;
    copy.released = released;
    copy.lastPathEnd = lastPathEnd;
    copy.lentRoom = lentRoom;
    return copy;
  }

  @Nullable ReservedPath path() {
    return path;
  }

  /** Rises whenever what it may drive, or has still to drive of that, becomes another. */
  long changes() {
    return changes;
  }

  int pathNumber() {
    return pathNumber;
  }

  /** How many sections are completed. */
  int completed() {
    return completed;
  }

  /** How many segments of its path are completed. */
  int completedSegments() {
    return completedSegments;
  }

  /** What it was lent beside its path; null: nothing. */
  @Nullable LentRoom lentRoom() {
    return lentRoom;
  }

  /** It has room beside its path from now on, and is to be told. */
  void lend(LentRoom room) {
    lentRoom = room;
    isRoomUnsent = true;
    changes++;
  }

  /** It has that room already, as after a restart. */
  void resumeRoom(LentRoom room) {
    lentRoom = room;
    isRoomUnsent = false;
    changes++;
  }

  /** It has no room beside its path any more. */
  void endRoom() {
    changes += lentRoom == null ? 0 : 1;
    lentRoom = null;
    isRoomUnsent = false;
  }

  /** What it may cover beside its path. */
  List<SweptArea> roomAreas() {
    return lentRoom == null ? List.of() : lentRoom.areasFrom(completedSegments);
  }

  /** How many sections it may drive. */
  int released() {
    return released;
  }

  /**
   * How many sections it is going to drive, whatever is planned: to the end of a cell's passage.
   */
  int committed() {
    return path == null ? 0 : path.committed(released);
  }

  Instant lastProgress() {
    return lastProgress;
  }

  /** Where the path before this one ended, map frame; null if there was none. */
  @Nullable Pose lastPathEnd() {
    return lastPathEnd;
  }

  /** Whether it is on a section that it may drive. */
  boolean isDriving() {
    return path != null && completed < released;
  }

  /** Whether it has driven all that it was given. */
  boolean isOver() {
    return path == null || isCompleted();
  }

  boolean hasUnreleased() {
    return path != null && released < path.sectionCount();
  }

  /** Whether a part of its path can still be planned otherwise. */
  boolean hasUncommitted() {
    return path != null && committed() < path.sectionCount();
  }

  /** Whether what is left of its path was planned together with others' paths. */
  boolean isOnSharedPath() {
    return path != null && path.isShared() && hasUncommitted();
  }

  boolean isCompleted() {
    return path != null && completed == path.sectionCount();
  }

  /** The sections that it may drive and has not completed. */
  private List<Section> ahead() {
    return path == null ? List.of() : path.sections().subList(completed, released);
  }

  /** The sections that it may not drive yet. */
  private List<Section> unreleased() {
    return path == null ? List.of() : path.sections().subList(released, path.sectionCount());
  }

  /** Whether one of the cells is on what it may drive and has not driven yet. */
  boolean hasAheadOn(BitSet cells) {
    return ahead().stream().anyMatch(section -> section.cells().intersects(cells));
  }

  /** Whether what it may not drive yet needs one of the cells. */
  boolean hasUnreleasedOn(BitSet cells) {
    return unreleased().stream().anyMatch(section -> section.cells().intersects(cells));
  }

  /** Whether what it may not drive yet comes nearer to an area than robots keep apart. */
  boolean hasUnreleasedNear(SweptArea area) {
    return unreleased().stream().anyMatch(section -> !Clearance.isKept(section.area(), area));
  }

  /**
   * What is left of the section that it is on.
   *
   * @param start where the first of the segments begins
   * @param segments those that are not completed
   */
  record OpenSection(Pose start, List<Segment> segments) {}

  /** Empty while it has nothing to drive. */
  Optional<OpenSection> openSection() {
    ReservedPath on = path;
    if (on == null || completed >= released) {
      return Optional.empty();
    }
    List<Segment> segments = on.sections().get(completed).segments();
    int done = Math.clamp(completedSegments - segmentsBefore, 0, segments.size() - 1);
    Pose start = on.poseAfter(completed);
    for (Segment segment : segments.subList(0, done)) {
      start = start.advanced(segment.twist(), segment.t());
    }
    return Optional.of(new OpenSection(start, segments.subList(done, segments.size())));
  }

  /** All that it may drive behind the section that it is on, in parts. */
  List<SweptArea> allocatedBehindOpen() {
    List<SweptArea> areas = new ArrayList<>();
    for (int i = completed + 1; path != null && i < released; i++) {
      areas.add(path.sections().get(i).area());
    }
    if (path != null && released > 0) {
      areas.add(path.sections().get(released - 1).endArea());
    }
    return areas;
  }

  /** What of its path lies behind the section that it is on. */
  RemainingPath.Behind behindOpen() {
    ReservedPath on = Objects.requireNonNull(path);
    RemainingPath.Behind known = behindOpen;
    if (known == null || !known.isOf(on, completed, released)) {
      known = RemainingPath.Behind.of(on, completed, released);
      behindOpen = known;
    }
    return known;
  }

  /** Seconds at the planned speed for what it may drive behind the section that it is on. */
  double secondsBehindOpen() {
    double seconds = 0;
    for (int i = completed + 1; path != null && i < released; i++) {
      seconds += path.sections().get(i).duration();
    }
    return seconds;
  }

  /** All that it may not drive yet, in parts. */
  List<SweptArea> unreleasedAreas() {
    return unreleased().stream().map(Section::area).toList();
  }

  /** Where the sections end that it may not drive yet, metres, map frame. */
  List<Vec2> uncommittedEnds() {
    return unreleased().stream().map(section -> section.end().position()).toList();
  }

  /** Begins another path where the part of this one ends that it is going to drive anyway. */
  void continueOn(ReservedPath next) {
    ReservedPath former = path;
    path = former == null ? next : former.continuedWith(committed(), next);
    if (former == null) {
      completed = 0;
      completedSegments = 0;
      segmentsBefore = 0;
      released = 0;
    }
    pathNumber++;
    changes++;
    isChangeUnsent = true;
  }

  /**
   * How much of a path it has been released since it was pictured, though on the path that it had
   * then.
   *
   * @param next goes on where the released part ended then
   * @return so many sections of it; below 0: its path does not lead there any more
   */
  int releasedAlong(ReservedPath next, Drive pictured) {
    ReservedPath now = path;
    if (pathNumber != pictured.pathNumber) {
      return -1;
    }
    if (now == null) {
      return 0;
    }
    int count = released - pictured.released;
    if (count > next.sectionCount()) {
      return -1;
    }
    for (int i = 1; i <= count; i++) {
      if (now.poseAfter(pictured.released + i).distanceTo(next.poseAfter(i)) > SAME_POINT) {
        return -1;
      }
    }
    return count;
  }

  /**
   * Takes the path of a plan that was made elsewhere.
   *
   * @param along so many of its sections are the last that it was released
   * @param releasedAtOnce so many of its sections it may drive by that
   * @param number of the path in that plan
   */
  void adopt(ReservedPath next, int along, int releasedAtOnce, int number) {
    if (path == null) {
      continueOn(next);
    } else {
      path = path.continuedWith(released, next, along);
      isChangeUnsent = true;
    }
    released += Math.max(0, releasedAtOnce - along);
    pathNumber = number;
    changes++;
  }

  /** The same visits in the same order, driven in other sections from the first unreleased on. */
  void replaceUnreleased(List<Section> sections, List<Integer> visitAtEnd) {
    path = Objects.requireNonNull(path).withSectionsFrom(released, sections, visitAtEnd);
    isChangeUnsent = true;
  }

  /** Who must have gone on before each visit of the path. */
  void setDependencies(List<List<ReservedPath.Dependency>> dependencies) {
    path = Objects.requireNonNull(path).withDependencies(dependencies);
  }

  /** The robot is known to drive this path already, all of which is released. */
  void resume(int completedSections, Instant now) {
    releaseAll();
    completed = Math.min(completedSections, released);
    changes++;
    segmentsBefore = Objects.requireNonNull(path).segmentCount(completed);
    completedSegments = segmentsBefore;
    isBegun = true;
    sentReleased = released;
    lastProgress = now;
  }

  void releaseNext(Instant now) {
    if (completed == released) {
      lastProgress = now;
    }
    released++;
    changes++;
  }

  void releaseAll() {
    released = Objects.requireNonNull(path).sectionCount();
    changes++;
  }

  /**
   * @param segments so many of the path's are completed
   * @return whether a section more than before is
   */
  boolean complete(int segments, Instant now) {
    changes += completedSegments == segments ? 0 : 1;
    completedSegments = path == null ? 0 : segments;
    int before = completed;
    while (path != null && completed < released && segmentsAfter(path) <= segments) {
      segmentsBefore = segmentsAfter(path);
      completed++;
    }
    if (completed == before) {
      return false;
    }
    changes++;
    lastProgress = now;
    return true;
  }

  /** Segments of the sections that are completed when the next one is too. */
  private int segmentsAfter(ReservedPath on) {
    return segmentsBefore + on.sections().get(completed).segments().size();
  }

  /** The robot is stopped: its progress is looked at from now on. */
  void restartProgress(Instant now) {
    lastProgress = now;
  }

  /** The robot is stopped and has no path. */
  void stop() {
    if (path != null) {
      lastPathEnd = path.poseAfter(released);
      changes++;
    }
    endRoom();
    path = null;
    completed = 0;
    completedSegments = 0;
    segmentsBefore = 0;
    released = 0;
    isBegun = false;
    sentReleased = 0;
    isChangeUnsent = false;
  }

  /**
   * Gives up what is not released.
   *
   * @return whether there was anything
   */
  boolean freeUnreleased() {
    return freeAfter(released);
  }

  /** Gives up what can still be planned otherwise. */
  void freeUncommitted() {
    freeAfter(committed());
  }

  private boolean freeAfter(int count) {
    ReservedPath former = path;
    if (former == null || count == former.sectionCount()) {
      return false;
    }
    path =
        former.continuedWith(count, ReservedPath.independent(former.poseAfter(count), List.of()));
    pathNumber++;
    isChangeUnsent = true;
    return true;
  }

  /** The room that it was lent, if it does not know of that; counts as told from now on. */
  Optional<DriveCommand> takeUnsentRoom(String robot) {
    if (lentRoom == null || !isRoomUnsent) {
      return Optional.empty();
    }
    isRoomUnsent = false;
    return Optional.of(new DriveCommand.Room(robot, lentRoom.room()));
  }

  /** Whether anything of its path has changed since it was told of that. */
  boolean hasChanged() {
    return !isBegun || isChangeUnsent || released != sentReleased;
  }

  /**
   * What the robot does not know yet of its path, if anything; counts as told from now on.
   *
   * @param endsAtGoal whether the path ends at its goal
   */
  Optional<DriveCommand> takeUnsentCommand(String robot, boolean endsAtGoal) {
    ReservedPath reserved = path;
    if (reserved == null) {
      return Optional.empty();
    }
    DriveCommand command = null;
    if (!isBegun) {
      command =
          new DriveCommand.Begin(
              robot, reserved.trajectory(), reserved.segmentCount(released), endsAtGoal);
    } else if (isChangeUnsent && released == sentReleased && hasUnreleased()) {
      // what it may not drive yet can change again before it may
      return Optional.empty();
    } else if (isChangeUnsent) {
      command =
          new DriveCommand.Extend(
              robot,
              reserved.segmentCount(sentReleased),
              reserved.segmentsFrom(sentReleased),
              reserved.segmentCount(released),
              endsAtGoal);
    } else if (released > sentReleased) {
      command = new DriveCommand.Release(robot, reserved.segmentCount(released));
    }
    isBegun = true;
    isChangeUnsent = false;
    sentReleased = released;
    return Optional.ofNullable(command);
  }
}
