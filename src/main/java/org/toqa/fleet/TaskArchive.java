package org.toqa.fleet;

import java.util.List;
import java.util.Optional;
import java.util.UUID;

/** Reads stored tasks and their history, ended ones too. Called by threads that may wait. */
public interface TaskArchive {

  /** Newest first. */
  List<TaskView> tasks(int offset, int limit);

  Optional<TaskView> task(long id);

  /** The task that was put in by this key. */
  Optional<TaskView> taskOf(UUID key);

  /** Oldest first. */
  List<EventRecord> history(long task);

  long count();
}
