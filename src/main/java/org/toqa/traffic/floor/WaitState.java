package org.toqa.traffic.floor;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;

/** Since when a robot waits, what for, and what it asks others to leave. */
final class WaitState {
  /** Metres; a robot that has moved by less stands. */
  private static final double MOVED = 0.05;

  /** Since when it is stopped short of its goal; null while it drives or has no goal. */
  private @Nullable Instant since;

  /** Since when it is stopped before a section that it may not enter. */
  private @Nullable Instant blockedSince;

  /** Why it may not enter the next section of its path; null while it may. */
  private @Nullable WaitReason blockedReason;

  /** Why it has no path to its goal; null while it has. */
  private @Nullable WaitReason noPathReason;

  private Instant noPathReasonFound = Instant.MIN;

  /** Who has its goal, by the last plan for all. */
  private @Nullable String goalTakenBy;

  /** When its own smooth path was last looked for. */
  private Instant lastSinglePlan = Instant.MIN;

  private boolean isSinglePlanLeft;

  /** Where it has stood since then. */
  private Vec2 place = Vec2.ZERO;

  private Instant standingSince = Instant.MAX;

  /** What a robot too large to be planned with the others waits for to become free. */
  private List<SweptArea> wanted = List.of();

  /** Another one in the same state. */
  WaitState copy() {
    WaitState copy = new WaitState();
    copy.since = since;
    copy.blockedSince = blockedSince;
    copy.blockedReason = blockedReason;
    copy.lastSinglePlan = lastSinglePlan;
    copy.place = place;
    copy.standingSince = standingSince;
    copy.noPathReason = noPathReason;
    copy.noPathReasonFound = noPathReasonFound;
    copy.goalTakenBy = goalTakenBy;
    copy.wanted = wanted;
    if (isSinglePlanLeft) {
      copy.lastSinglePlan = Instant.MIN;
    }
    return copy;
  }

  /**
   * What planning finds out of a robot that has no path.
   *
   * @param noPathReason null: it has one
   * @param found when that was found
   * @param isSinglePlanLeft whether its own path was due, and there was no time to look for it
   */
  record Findings(
      @Nullable WaitReason noPathReason,
      Instant found,
      @Nullable String goalTakenBy,
      List<SweptArea> wanted,
      boolean isSinglePlanLeft) {}

  Findings findings() {
    return new Findings(noPathReason, noPathReasonFound, goalTakenBy, wanted, isSinglePlanLeft);
  }

  void adopt(Findings findings) {
    noPathReason = findings.noPathReason();
    noPathReasonFound = findings.found();
    goalTakenBy = findings.goalTakenBy();
    wanted = findings.wanted();
    if (findings.isSinglePlanLeft()) {
      lastSinglePlan = Instant.MIN;
    }
  }

  @Nullable Instant since() {
    return since;
  }

  /** It is there. */
  void observe(Vec2 at, Instant now) {
    if (place.distanceTo(at) > MOVED) {
      place = at;
      standingSince = now;
    }
  }

  /** That it stands counts from now on. */
  void restartStanding(Instant now) {
    standingSince = now;
  }

  Instant standingSince() {
    return standingSince;
  }

  boolean isStandingFor(Duration time, Instant now) {
    return !standingSince.isAfter(now.minus(time));
  }

  @Nullable String goalTakenBy() {
    return goalTakenBy;
  }

  @Nullable WaitReason noPathReason() {
    return noPathReason;
  }

  @Nullable WaitReason blockedReason() {
    return blockedReason;
  }

  /** What others shall leave. */
  List<SweptArea> wanted() {
    return wanted;
  }

  /** Forgets all that it waited for, as for another goal. */
  void restart(@Nullable Instant newSince) {
    since = newSince;
    noPathReason = null;
    goalTakenBy = null;
    setWanted(List.of());
  }

  void setSince(@Nullable Instant newSince) {
    since = newSince;
  }

  /** It has a path to its goal. */
  void endWaitForPath() {
    noPathReason = null;
    since = null;
  }

  void setGoalTakenBy(@Nullable String robot) {
    goalTakenBy = robot;
  }

  /** These areas are what it waits for. */
  void setWanted(List<SweptArea> areas) {
    wanted = areas;
  }

  // --- no path ----------------------------------------------------------------------------------

  boolean isNoPathReasonOlderThan(Duration age, Instant now) {
    return noPathReason == null || noPathReasonFound.plus(age).isBefore(now);
  }

  /** When it was last found out why it has no path; of one that never had to wait, long ago. */
  Instant noPathReasonFound() {
    return noPathReasonFound;
  }

  void setNoPathReason(WaitReason reason, Instant now) {
    noPathReason = reason;
    noPathReasonFound = now;
  }

  void clearNoPathReason() {
    noPathReason = null;
  }

  boolean isSinglePlanOlderThan(Duration age, Instant now) {
    return lastSinglePlan.plus(age).isBefore(now);
  }

  /** While paths are planned: there is no time to look for its own. */
  void leaveSinglePlan() {
    isSinglePlanLeft = true;
  }

  void recordSinglePlan(Instant now) {
    lastSinglePlan = now;
  }

  // --- before a section -------------------------------------------------------------------------

  /** Its path goes on otherwise: nothing is known of what may bar that. */
  void forgetPath() {
    blockedReason = null;
    lastSinglePlan = Instant.MIN;
  }

  /** The same again leaves what is known, so that its sentence need not be made anew. */
  void setBlockedReason(@Nullable WaitReason reason) {
    if (!Objects.equals(blockedReason, reason)) {
      blockedReason = reason;
    }
  }

  /** Since when it is stopped before the section: from now on, if it did not before. */
  Instant blockedSince(Instant now) {
    Instant known = blockedSince == null ? now : blockedSince;
    blockedSince = known;
    return known;
  }

  /** The section before which it was stopped is another one now. */
  void restartBlocked() {
    blockedSince = null;
  }

  /** It may enter the next section. */
  void unblock() {
    blockedSince = null;
    blockedReason = null;
  }
}
