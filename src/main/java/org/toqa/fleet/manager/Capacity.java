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
   * The smallest team that carries the load in even shares, of the narrowest robots; empty where
   * one robot carries it, or none of the teams that there are.
   */
  Optional<List<Candidate>> narrowestTeam(TransportTask task) {
    List<Candidate> here = robots.getOrDefault(task.floor(), List.of());
    return TeamSize.smallest(task.load(), here)
        .filter(size -> size > 1)
        .map(
            size ->
                here.stream()
                    .filter(robot -> robot.maxLoad() * size >= task.load())
                    .sorted(Comparator.comparingDouble(Candidate::diameter))
                    .limit(size)
                    .toList());
  }
}
