package org.toqa.fleet;

import java.util.List;
import java.util.Optional;

/** Every task that was ever stored. Any thread may read; it sees what is committed. */
public interface TaskArchive {

  /**
   * @param offset how many of the newest to leave out
   * @param limit how many to answer at most
   * @return newest first
   */
  List<TaskView> tasks(int offset, int limit);

  Optional<TaskView> task(long id);

  /** What happened to a task, oldest first; empty for an unknown one. */
  List<EventRecord> history(long id);

  long count();
}
