package org.toqa.allocation;

import static java.util.Comparator.comparingDouble;

import java.util.List;
import org.toqa.allocation.InTurn.Chosen;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * The free robot nearest to the load, as the crow flies, of those that can carry it. What the
 * others are measured against.
 */
public final class NearestFreeRobot implements Allocator {

  @Override
  public List<Decision> allocate(Situation situation) {
    Costs costs = new Costs(situation);
    return InTurn.decide(
        situation,
        (job, left) ->
            left.stream()
                .filter(r -> costs.of(job, r).isPossible())
                .min(comparingDouble(r -> r.position().distanceTo(job.start())))
                .map(r -> new Chosen(r, why(r, job))));
  }

  private static Sentence why(Candidate robot, Job job) {
    return Phrase.NEAREST_FREE.with(robot.position().distanceTo(job.start()));
  }
}
