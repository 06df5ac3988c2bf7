package org.toqa.fleet;

import java.time.Instant;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.mission.Mission;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.Phase;
import org.toqa.mission.TransportTask;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * One line of the history.
 *
 * @param kind the text of an {@link EventKind}, or of one that an earlier version knew
 * @param task the task it concerns, if any
 * @param robot the robot it concerns, if any
 * @param who a user's name, or {@code toqa}
 * @param floor the floor it concerns; null: that of its task or robot, or none
 */
public record EventRecord(
    Instant at,
    String kind,
    @Nullable Long task,
    @Nullable String robot,
    String who,
    Sentence sentence,
    @Nullable String floor) {

  /** Characters; a robot may say more than the history keeps. */
  private static final int LONGEST_TEXT = 500;

  /** Who acts when no person does. */
  public static final String SYSTEM = "toqa";

  public EventRecord(
      Instant at,
      EventKind kind,
      @Nullable Long task,
      @Nullable String robot,
      String who,
      Sentence sentence) {
    this(at, kind.text(), task, robot, who, sentence, null);
  }

  /** With a kind that perhaps only an earlier version knew. */
  public EventRecord(
      Instant at,
      String kind,
      @Nullable Long task,
      @Nullable String robot,
      String who,
      Sentence sentence) {
    this(at, kind, task, robot, who, sentence, null);
  }

  public EventRecord onFloor(String name) {
    return new EventRecord(at, kind, task, robot, who, sentence, name);
  }

  /** In English. */
  public String text() {
    String text = sentence.english();
    return text.length() <= LONGEST_TEXT ? text : text.substring(0, LONGEST_TEXT - 3) + "...";
  }

  /**
   * What the history says of a new task.
   *
   * @param task has its id
   */
  public static EventRecord added(TransportTask task) {
    return new EventRecord(
            task.createdAt(),
            EventKind.TASK_ADDED,
            task.id(),
            null,
            task.user(),
            Phrase.ASKED_FOR_BY.with(task.user()))
        .onFloor(task.floor());
  }

  /** What the history says of a mission's step. */
  public static List<EventRecord> of(Mission.Step step, MissionEvent event, Instant at) {
    String robot = event instanceof MissionEvent.OfRobot e ? e.robot() : null;
    String who = event instanceof MissionEvent.OperatorCommand command ? command.user() : SYSTEM;
    long task = step.mission().id();
    String floor = step.mission().task().floor();
    EventKind kind = isAtStop(step.mission(), event) ? EventKind.TASK_AT_STOP : EventKind.of(event);
    return step.history().stream()
        .map(said -> new EventRecord(at, kind, task, robot, who, said).onFloor(floor))
        .toList();
  }

  /** Whether a robot has come to a stop of its way, at which nothing is delivered. */
  private static boolean isAtStop(Mission after, MissionEvent event) {
    if (!(event instanceof MissionEvent.PhaseEnded ended)) {
      return false;
    }
    return after.task().isDrive()
        ? ended.phase() == Phase.TO_OBJECT
        : ended.phase() == Phase.TO_GOAL
            && !after.task().stops().isEmpty()
            && !after.state().isDelivered();
  }
}
