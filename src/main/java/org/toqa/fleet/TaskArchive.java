package org.toqa.fleet;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.UUID;
import org.jspecify.annotations.Nullable;
import org.toqa.mission.TaskState;

/** Reads stored tasks and their history, ended ones too. Called by threads that may wait. */
public interface TaskArchive {

  List<TaskView> tasks(Filter filter, Sort sort, int offset, int limit);

  /** Newest first. */
  default List<TaskView> tasks(int offset, int limit) {
    return tasks(Filter.ANY, Sort.NEWEST_FIRST, offset, limit);
  }

  Optional<TaskView> task(long id);

  /** The task that was put in by this key. */
  Optional<TaskView> taskByKey(UUID key);

  /** Oldest first. */
  List<EventRecord> history(long task);

  long count(Filter filter);

  default long count() {
    return count(Filter.ANY);
  }

  /**
   * Which tasks are wanted; null: any.
   *
   * @param states empty: any
   * @param robot that carries or carried it
   * @param user who asked for it, in upper or lower case
   * @param text a part of its name, in upper or lower case, or its number
   * @param from the first moment at which it was asked for
   * @param until the first moment after it
   * @param follower the id of the account that follows it
   * @param floor where it is
   */
  record Filter(
      Set<TaskState> states,
      @Nullable String robot,
      @Nullable String user,
      @Nullable String text,
      @Nullable Instant from,
      @Nullable Instant until,
      @Nullable Long follower,
      @Nullable String floor) {
    public static final Filter ANY = new Filter(Set.of(), null, null, null, null, null, null);

    /** Of all floors. */
    public Filter(
        Set<TaskState> states,
        @Nullable String robot,
        @Nullable String user,
        @Nullable String text,
        @Nullable Instant from,
        @Nullable Instant until,
        @Nullable Long follower) {
      this(states, robot, user, text, from, until, follower, null);
    }
  }

  /** In which order; what is alike comes newest first. */
  record Sort(Column by, boolean descending) {
    public static final Sort NEWEST_FIRST = new Sort(Column.ID, true);

    public enum Column {
      ID,
      NAME,
      STATE,
      LOAD,
      USER,
      CREATED
    }
  }
}
