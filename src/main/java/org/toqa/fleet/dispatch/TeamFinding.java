package org.toqa.fleet.dispatch;

import java.util.List;
import java.util.Optional;
import org.toqa.allocation.Candidate;
import org.toqa.mission.Mission;
import org.toqa.wording.Sentence;

/**
 * Whether a team has room for a task, as it was when that was asked.
 *
 * @param objection why it has none; empty: it has
 */
record TeamFinding(PathQuery.TeamQuestion question, Optional<Sentence> objection) {

  /** Whether it says so of the task as it is now, and of these robots. */
  boolean isAbout(Mission mission, List<Candidate> team) {
    return question.equals(PathQuery.TeamQuestion.of(mission, team));
  }
}
