package org.toqa.fleet.manager;

import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.fleet.FleetStore;
import org.toqa.fleet.RobotRecord;
import org.toqa.mission.TransportTask;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * Floors that the store's robots and tasks name, and that were not there when the fleet started.
 * Any thread may ask.
 */
final class MissingFloors {
  private static final Logger log = LoggerFactory.getLogger(MissingFloors.class);

  private final Map<String, Sentence> sentences = new TreeMap<>();
  private final Map<Long, String> tasks = new HashMap<>();
  private final Predicate<String> isThere;

  private MissingFloors(Predicate<String> isThere) {
    this.isThere = isThere;
  }

  /**
   * @param isThere whether there is a floor of that name now
   */
  static MissingFloors of(FleetStore store, Predicate<String> isThere) {
    MissingFloors missing = new MissingFloors(isThere);
    List<String> ofRobots = store.robots().stream().map(RobotRecord::floor).toList();
    List<TransportTask> open =
        store.openTasks().stream().map(task -> task.mission().task()).toList();
    List<String> ofTasks = open.stream().map(TransportTask::floor).toList();
    Stream.concat(ofRobots.stream(), ofTasks.stream())
        .filter(isThere.negate())
        .distinct()
        .forEach(
            floor -> {
              Sentence said =
                  Phrase.FLOOR_IS_MISSING.with(
                      floor,
                      Collections.frequency(ofRobots, floor),
                      Collections.frequency(ofTasks, floor));
              missing.sentences.put(floor, said);
              log.warn("{}", said.english());
            });
    open.stream()
        .filter(task -> missing.sentences.containsKey(task.floor()))
        .forEach(task -> missing.tasks.put(task.id(), task.floor()));
    return missing;
  }

  /** By floor, what is said of it. */
  Map<String, Sentence> sentences() {
    return Collections.unmodifiableMap(sentences);
  }

  /** What is said of the floor until it is added. */
  Optional<Sentence> alert(String floor) {
    return isThere.test(floor) ? Optional.empty() : Optional.ofNullable(sentences.get(floor));
  }

  /** Why nothing can be done with a task. */
  Optional<Sentence> alertOfTask(long task) {
    return Optional.ofNullable(tasks.get(task)).flatMap(this::alert);
  }
}
