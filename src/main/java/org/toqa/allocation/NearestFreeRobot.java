package org.toqa.allocation;

import static java.util.Comparator.comparingDouble;

import java.util.List;
import org.toqa.allocation.SequentialAllocation.Chosen;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * The free robot nearest to the load in a straight line, of those that can carry it. What the
 * others are measured against.
 */
public final class NearestFreeRobot implements Allocator {

  @Override
  public List<Decision> allocate(AllocationProblem problem) {
    Quotes quotes = problem.quotes();
    return SequentialAllocation.allocate(
        problem,
        (task, left) ->
            left.stream()
                .filter(r -> quotes.of(task, r).isPossible())
                .min(comparingDouble(r -> r.position().distanceTo(task.start())))
                .map(r -> new Chosen(r, reason(r, task))));
  }

  private static Sentence reason(Candidate robot, AllocationTask task) {
    Phrase nearest = task.isDrive() ? Phrase.NEAREST_FREE_FOR_DRIVE : Phrase.NEAREST_FREE;
    return nearest.with(robot.position().distanceTo(task.start()));
  }
}
