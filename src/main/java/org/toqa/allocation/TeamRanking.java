package org.toqa.allocation;

import java.util.Comparator;
import java.util.List;
import org.toqa.wording.Sentence;

/** Who comes first into a team, of the robots that are free and can carry their share. */
interface TeamRanking {

  /**
   * @param approach its path to the load, metres
   */
  record Member(Candidate robot, double approach) {}

  /** The team is made of the least ones, and the least of all leads. */
  Comparator<Member> order(AllocationTask task);

  /**
   * @param team the leader first
   * @return completes "Given to r1, r2: "
   */
  Sentence reason(AllocationTask task, List<Member> team);
}
