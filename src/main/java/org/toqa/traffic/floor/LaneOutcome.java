package org.toqa.traffic.floor;

/** What came of planning robots together on lane cells. */
enum LaneOutcome {
  /** All have paths by the new plan. */
  PLANNED,
  /** All have the next steps of their paths. */
  PLANNED_AHEAD,
  /** Those without a path can only stay, and nobody could make room: no plan would help now. */
  NOT_NEEDED,
  NOT_FOUND
}
