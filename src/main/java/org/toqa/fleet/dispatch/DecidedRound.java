package org.toqa.fleet.dispatch;

import java.util.List;
import org.toqa.allocation.Decision;
import org.toqa.allocation.NegotiationLine;

/**
 * What came of a round of allocation.
 *
 * @param decisions none where it failed
 * @param lines what was said in it; none where nobody was asked
 * @param isUnfinished whether it is worth another round soon: somebody has not answered, or has
 *     refused what was awarded
 */
record DecidedRound(List<Decision> decisions, List<NegotiationLine> lines, boolean isUnfinished) {

  static DecidedRound of(List<Decision> decisions) {
    return new DecidedRound(decisions, List.of(), false);
  }
}
