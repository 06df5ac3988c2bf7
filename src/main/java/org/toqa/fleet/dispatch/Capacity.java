package org.toqa.fleet.dispatch;

import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import org.toqa.allocation.Candidate;
import org.toqa.allocation.TeamSize;
import org.toqa.mission.TransportTask;

/**
 * What all robots of a floor can carry, whatever they do now.
 *
 * @param total of all together, kilograms
 * @param robots those that were reported
 */
record Capacity(double total, List<Candidate> robots) {

  /**
   * The teams whose room is looked at: the smallest whose maximum loads add up to the load, of the
   * narrowest robots, and the same of those alone that can go sideways, which take tighter corners.
   * Empty where one robot carries it, or no team that there is.
   */
  List<List<Candidate>> narrowestTeams(TransportTask task) {
    return narrowestTeams(task, robots);
  }

  /**
   * The same of these.
   *
   * @param robots of the task's floor
   */
  static List<List<Candidate>> narrowestTeams(TransportTask task, List<Candidate> robots) {
    List<Candidate> narrowestFirst =
        robots.stream().sorted(Comparator.comparingDouble(Candidate::diameter)).toList();
    if (TeamSize.smallest(task.load(), narrowestFirst).filter(size -> size > 1).isEmpty()) {
      return List.of();
    }
    return Stream.of(
            narrowestFirst, narrowestFirst.stream().filter(Candidate::isOmnidirectional).toList())
        .flatMap(
            among ->
                TeamSize.smallest(task.load(), among)
                    .map(size -> TeamSize.first(task.load(), size, among))
                    .stream())
        .distinct()
        .toList();
  }
}
