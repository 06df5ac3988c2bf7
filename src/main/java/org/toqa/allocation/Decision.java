package org.toqa.allocation;

import java.util.List;

/** What an allocator answers for a task, with its reason as a sentence for people. */
public sealed interface Decision {

  /** The task's id. */
  long job();

  String why();

  /**
   * These robots shall carry it.
   *
   * @param why completes "Given to r1: "
   */
  record Assigned(long job, List<String> robots, String why) implements Decision {
    public Assigned {
      robots = List.copyOf(robots);
    }
  }

  record Waits(long job, String why) implements Decision {}
}
