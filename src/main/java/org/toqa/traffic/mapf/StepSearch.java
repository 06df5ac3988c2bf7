package org.toqa.traffic.mapf;

/** Chooses the next places of all robots at once. */
interface StepSearch {

  /**
   * @param places where the robots stand
   * @param order the robots by falling priority
   * @param constraints robots that must go where they are told
   * @param next receives the places after the step
   * @return false where the orders leave some robot no place
   */
  boolean step(int[] places, int[] order, Lacam.Constraints constraints, int[] next);
}
