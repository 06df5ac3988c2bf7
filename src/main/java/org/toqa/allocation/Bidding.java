package org.toqa.allocation;

import java.util.List;
import java.util.stream.IntStream;
import org.toqa.allocation.Auction.Reply;
import org.toqa.allocation.Costs.Cost;

/** How robots answer the announcement of a task. */
@FunctionalInterface
interface Bidding {

  /**
   * @param invited robots that are free
   * @return the answers that come, in the order in which they come
   */
  List<Reply> replies(AllocationProblem problem, AllocationTask task, List<Candidate> invited);

  /** What each robot's agent on the server computes, at once. */
  static List<Reply> computedReplies(
      AllocationProblem problem, AllocationTask task, List<Candidate> invited) {
    List<Cost> costs = new Costs(problem).of(task, invited);
    return IntStream.range(0, invited.size())
        .<Reply>mapToObj(
            i ->
                costs.get(i).isPossible()
                    ? new Auction.Bid(invited.get(i).robot(), costs.get(i).joules(), problem.now())
                    : new Auction.Refusal(invited.get(i).robot(), problem.now()))
        .toList();
  }
}
