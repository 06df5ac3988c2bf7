package org.toqa.fleet.dispatch;

import java.util.List;
import java.util.stream.Stream;
import org.toqa.allocation.AllocationTask;
import org.toqa.fleet.RobotView;
import org.toqa.mission.RobotAbility;
import org.toqa.mission.TransportTask;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * Which robots of a floor are meant where a task allows some alone, by name or by what they can do.
 *
 * @param floor its robots
 */
record ChosenRobots(List<RobotView> floor) {
  /** Of so many robots each is named. */
  private static final int NAMED = 3;

  /**
   * Their names. An ability that no robot has stays as it is, for then nobody is meant, and an
   * empty list means all.
   *
   * @param onlyRobots names and abilities
   */
  List<String> names(List<String> onlyRobots) {
    return hasAbility(onlyRobots)
        ? onlyRobots.stream().flatMap(this::names).distinct().toList()
        : onlyRobots;
  }

  private static boolean hasAbility(List<String> onlyRobots) {
    return onlyRobots.stream().anyMatch(word -> RobotAbility.of(word).isPresent());
  }

  private Stream<String> names(String word) {
    List<String> able =
        RobotAbility.of(word).stream()
            .flatMap(ability -> floor.stream().filter(robot -> has(robot, ability)))
            .map(RobotView::name)
            .toList();
    return able.isEmpty() ? Stream.of(word) : able.stream();
  }

  /** Of a robot that was never connected nothing is known. */
  private static boolean has(RobotView robot, RobotAbility ability) {
    return robot.isLoadKnown()
        && switch (ability) {
          case ARM -> robot.capabilities().arm() != null;
          case SIDEWAYS -> robot.capabilities().kind().canGoSideways();
        };
  }

  /** The same task for those by their names. */
  TransportTask named(TransportTask task) {
    return hasAbility(task.onlyRobots()) ? task.withOnlyRobots(names(task.onlyRobots())) : task;
  }

  AllocationTask named(AllocationTask job) {
    return hasAbility(job.onlyRobots())
        ? job.withOnlyRobots(names(job.onlyRobots()), sentence(job.onlyRobots()))
        : job;
  }

  /** What they are called: as they were chosen, and who that is here where they are few. */
  private Sentence sentence(List<String> onlyRobots) {
    Sentence chosen = words(onlyRobots);
    List<String> names =
        names(onlyRobots).stream().filter(name -> RobotAbility.of(name).isEmpty()).toList();
    return names.isEmpty() || names.size() > NAMED
        ? chosen
        : Phrase.CHOSEN_HERE.with(chosen, Sentence.names(names));
  }

  static Sentence words(List<String> onlyRobots) {
    return Sentence.joined(Phrase.LISTED, onlyRobots.stream().map(RobotAbility::sentence).toList());
  }
}
