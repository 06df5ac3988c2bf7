package org.toqa.fleet.dispatch;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.toqa.allocation.Candidate;
import org.toqa.allocation.TeamSize;
import org.toqa.fleet.RobotView;
import org.toqa.mission.TransportTask;

/**
 * What all robots of a floor can carry, whatever they do now.
 *
 * @param total of all together, kilograms
 * @param robots those that were reported
 * @param maxLoads by name of each robot that was added to the floor, kilograms
 * @param floor all its robots
 */
record Capacity(
    double total, List<Candidate> robots, Map<String, Double> maxLoads, List<RobotView> floor) {

  /** Of robots of which nothing else is known. */
  Capacity(double total, List<Candidate> robots, Map<String, Double> maxLoads) {
    this(total, robots, maxLoads, List.of());
  }

  /** Which of the robots' arms can do what. */
  ArmReach arms() {
    return ArmReach.of(floor);
  }

  /** Who is meant where a task allows some robots alone. */
  ChosenRobots chosen() {
    return new ChosenRobots(floor);
  }

  /** Whether the robots that may carry the task are strong enough, alone or together. */
  boolean isEnoughFor(TransportTask task) {
    return isEnoughFor(task.load(), chosen().names(task.onlyRobots()));
  }

  /**
   * @param load kilograms
   * @param onlyRobots names of those that may carry it; empty: all
   */
  boolean isEnoughFor(double load, List<String> onlyRobots) {
    if (onlyRobots.isEmpty()) {
      return load <= total;
    }
    List<Candidate> reported =
        robots.stream().filter(robot -> onlyRobots.contains(robot.robot())).toList();
    return maxLoads.keySet().containsAll(onlyRobots)
        && load <= together(onlyRobots)
        && (reported.size() < onlyRobots.size() || TeamSize.smallest(load, reported).isPresent());
  }

  /** What these carry together, kilograms. */
  double together(List<String> chosen) {
    return chosen.stream().mapToDouble(robot -> maxLoads.getOrDefault(robot, 0.0)).sum();
  }

  /**
   * The teams whose room is looked at: the smallest whose maximum loads add up to the load, of the
   * narrowest robots, and the same of those alone that can go sideways, which take tighter corners.
   * Empty where one robot carries it, or no team that there is.
   */
  List<List<Candidate>> narrowestTeams(TransportTask task) {
    return narrowestTeams(chosen().named(task), robots);
  }

  /**
   * The same of these.
   *
   * @param task that names the robots which alone may carry it
   * @param robots of the task's floor
   */
  static List<List<Candidate>> narrowestTeams(TransportTask task, List<Candidate> robots) {
    List<Candidate> narrowestFirst =
        robots.stream()
            .filter(robot -> task.allows(robot.robot()))
            .sorted(Comparator.comparingDouble(Candidate::diameter))
            .toList();
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
