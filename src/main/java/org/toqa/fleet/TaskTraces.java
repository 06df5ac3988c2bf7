package org.toqa.fleet;

/**
 * Which tasks people follow, each a list of his own (Tanta: a user traces many tasks). Called by
 * threads that may wait; what is said twice is kept once.
 */
public interface TaskTraces {

  /**
   * The user follows the task, or does not any more.
   *
   * @param user the id of his account
   */
  void setFollowed(long user, long task, boolean followed);

  boolean isFollowed(long user, long task);
}
