package org.toqa.allocation;

import java.util.List;
import org.toqa.wording.Sentence;

/** What an allocator answers for a task, with its reason as a sentence for people. */
public sealed interface Decision {

  /** The task's id. */
  long job();

  Sentence why();

  /**
   * These robots shall carry it.
   *
   * @param why completes "Given to r1: "
   */
  record Assigned(long job, List<String> robots, Sentence why) implements Decision {
    public Assigned {
      robots = List.copyOf(robots);
    }
  }

  /**
   * No robot carries it yet.
   *
   * @param drained robots that are free and would do it if they had charged
   */
  record Waits(long job, Sentence why, List<String> drained) implements Decision {
    public Waits {
      drained = List.copyOf(drained);
    }
  }
}
