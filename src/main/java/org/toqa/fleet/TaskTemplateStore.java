package org.toqa.fleet;

import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Keeps templates of tasks; who changes them is in the history. Each call is one transaction; it
 * throws {@link org.toqa.persistence.StoreException} when the store does not answer. Called by
 * threads that may wait.
 */
public interface TaskTemplateStore {

  /** By their names. */
  List<TaskTemplate> templates();

  Optional<TaskTemplate> template(long id);

  /**
   * Adds one; its id is given here, its owner is the user of that name.
   *
   * @return empty: another has its name
   */
  Optional<TaskTemplate> add(TaskTemplate template);

  /** What became of a change. */
  enum Change {
    DONE,
    /** Another template has that name. */
    NAME_TAKEN,
    /** It is not what was seen any more, or other schedules use it. */
    OUTDATED
  }

  /**
   * Makes a template another one, and with it the orders of all schedules that use it.
   *
   * @param seen as it was when the new one was made
   * @param orders of each schedule that uses it, by its id
   * @param by the user who changes it
   */
  Change replace(TaskTemplate seen, TaskTemplate changed, Map<Long, TaskOrder> orders, String by);

  /**
   * Deletes one that no schedule uses.
   *
   * @return the schedules that use it; empty: it is gone
   */
  List<Long> delete(TaskTemplate template, String by);
}
