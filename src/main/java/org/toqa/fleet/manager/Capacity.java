package org.toqa.fleet.manager;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.toqa.allocation.Candidate;
import org.toqa.allocation.TeamSize;
import org.toqa.mission.TransportTask;

/**
 * What all robots that there are can carry, whatever they do now.
 *
 * @param total of all together, kilograms
 * @param robots by floor, those that were reported
 */
record Capacity(double total, Map<String, List<Candidate>> robots) {

  /**
   * The smallest team whose maximum loads add up to the load, of the narrowest robots; empty where
   * one robot carries it, or none of the teams that there are.
   */
  Optional<List<Candidate>> narrowestTeam(TransportTask task) {
    List<Candidate> narrowestFirst =
        robots.getOrDefault(task.floor(), List.of()).stream()
            .sorted(Comparator.comparingDouble(Candidate::diameter))
            .toList();
    return TeamSize.smallest(task.load(), narrowestFirst)
        .filter(size -> size > 1)
        .map(size -> TeamSize.first(task.load(), size, narrowestFirst));
  }
}
