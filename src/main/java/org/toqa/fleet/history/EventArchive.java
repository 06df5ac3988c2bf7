package org.toqa.fleet.history;

import java.time.Instant;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.EventRecord;

/** Reads everything that has happened. Called by threads that may wait. */
public interface EventArchive {

  /**
   * Events that come before the one with that id, newest first.
   *
   * @param before an id; those of later events are higher
   * @param limit how many at most
   */
  List<Entry> events(Filter filter, long before, int limit);

  /** The names of all robots that there are or were, in order. */
  List<String> robots();

  /**
   * One line of the history and its place in it.
   *
   * @param id rises with every event
   */
  record Entry(long id, EventRecord event) {}

  /**
   * Which events are wanted; null: any.
   *
   * @param kind a kind such as {@code task.delivered}, or a family of them such as {@code task}
   * @param user who did it, or {@code toqa}
   * @param from the first moment
   * @param until the first moment after it
   * @param users whether what managers did with users and webhooks is wanted too
   * @param sites whether what administrators did with sites is wanted too
   * @param floor that it concerns
   */
  record Filter(
      @Nullable Long task,
      @Nullable String robot,
      @Nullable String user,
      @Nullable String kind,
      @Nullable Instant from,
      @Nullable Instant until,
      boolean users,
      boolean sites,
      @Nullable String floor) {

    /** Of all floors. */
    public Filter(
        @Nullable Long task,
        @Nullable String robot,
        @Nullable String user,
        @Nullable String kind,
        @Nullable Instant from,
        @Nullable Instant until,
        boolean users) {
      this(task, robot, user, kind, from, until, users, users, null);
    }
  }
}
