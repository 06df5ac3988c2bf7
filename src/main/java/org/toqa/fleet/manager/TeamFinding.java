package org.toqa.fleet.manager;

import java.util.Optional;
import org.toqa.mission.Mission;
import org.toqa.wording.Sentence;

/**
 * Whether a team has room for a task, as it was when that was asked.
 *
 * @param objection why it has none; empty: it has
 */
record TeamFinding(PathQuery.TeamQuestion question, Optional<Sentence> objection) {

  /** Whether it says so of the task as it is now, and of so many robots. */
  boolean isAbout(Mission mission, int robots) {
    return question.equals(PathQuery.TeamQuestion.of(mission, robots));
  }
}
