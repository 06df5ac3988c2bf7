package org.toqa.allocation;

import java.util.List;
import org.toqa.wording.Sentence;

/** What an allocator answers for a task, with its reason as a sentence for people. */
public sealed interface Decision {

  /** The task's id. */
  long task();

  Sentence reason();

  /**
   * These robots shall carry it.
   *
   * @param task the task's id
   * @param reason completes "Given to r1: "
   */
  record Assigned(long task, List<String> robots, Sentence reason) implements Decision {
    public Assigned {
      robots = List.copyOf(robots);
    }
  }

  /**
   * No robot carries it yet.
   *
   * @param task the task's id
   * @param drained robots that are free and would do it if they had charged
   */
  record Unassigned(long task, Sentence reason, List<String> drained) implements Decision {
    public Unassigned {
      drained = List.copyOf(drained);
    }
  }
}
