package org.toqa.notices;

import java.time.Duration;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;

/** What a notice is about. */
public enum NoticeKind {
  /** A task asks what a person must decide. */
  TASK_QUESTION,
  /** A task waits for what does not come by itself. */
  TASK_BLOCKED,
  /** A task will not meet its deadline. */
  TASK_LATE,
  ROBOT_ERROR,
  /** Its own hardware has stopped it, until a person clears that. */
  ROBOT_STOPPED,
  ROBOT_LOST(Duration.ofSeconds(10)),
  ROBOT_NOT_LOCALISED(Duration.ofSeconds(10)),
  /** It must charge, and reaches no charger. */
  ROBOT_BATTERY,
  /** A reading is beyond its limits. */
  ROBOT_READING,
  /** It stands in the way, or it and the server do not trust each other. */
  ROBOT_ALERT,
  STANDSTILL,
  CHARGER_FAULTY,
  CHARGERS_SHORT(Duration.ofSeconds(30)),
  LOAD_LEFT,
  /**
   * The fleet refused the task of a schedule when it was due; told for an hour, as it has no end.
   */
  SCHEDULE_REFUSED(Duration.ZERO),
  FLOOR_HELD,
  FLEET_PAUSED,
  /** The database is away, the memory short, or what else hinders the server. */
  SERVER;

  /** All of them. */
  public static final Set<NoticeKind> ALL = Set.copyOf(EnumSet.allOf(NoticeKind.class));

  private final Duration patience;

  NoticeKind() {
    this(Duration.ofSeconds(2));
  }

  NoticeKind(Duration patience) {
    this.patience = patience;
  }

  /** For how long it must last until it is told, and be over until its end is. */
  Duration patience() {
    return patience;
  }

  /** Whether it is about a task, which is somebody's own. */
  public boolean isOfTask() {
    return this == TASK_QUESTION || this == TASK_BLOCKED || this == TASK_LATE || this == LOAD_LEFT;
  }

  /** As programs and the store name it, such as {@code robot-lost}. */
  public String word() {
    return name().toLowerCase(Locale.ROOT).replace('_', '-');
  }

  public static Optional<NoticeKind> ofWord(String word) {
    return Arrays.stream(values()).filter(kind -> kind.word().equals(word)).findFirst();
  }
}
