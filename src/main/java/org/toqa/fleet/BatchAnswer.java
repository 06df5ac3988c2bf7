package org.toqa.fleet;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.wording.Sentence;

/** What the fleet answers to orders of which all are wanted or none. */
public sealed interface BatchAnswer {

  /**
   * All are stored.
   *
   * @param tasks in the order in which they were asked for
   */
  record Accepted(List<TaskView> tasks) implements BatchAnswer {}

  /**
   * Nothing was stored.
   *
   * @param rejections one for each order that was refused, in their order
   */
  record Rejected(List<Rejection> rejections) implements BatchAnswer {}

  /**
   * @param index of the order in the list, from 0
   * @param field the field of the order that is at fault, if it is one
   * @param sentence what is wrong and what to do, for a person
   */
  record Rejection(int index, @Nullable String field, Sentence sentence) {}
}
