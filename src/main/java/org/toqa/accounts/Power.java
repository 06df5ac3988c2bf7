package org.toqa.accounts;

/** Of what a role is made: one thing that a user may do. */
public enum Power {
  /** See tasks, robots, map, floors, statistics and history; follow tasks. */
  VIEW,
  /** Add tasks and schedules, and change his own. */
  ORDER,
  /** Pause all robots. */
  PAUSE,
  /**
   * Change others' tasks and answer what they ask; hold, resume and send home robots and floors,
   * clear their stops, say where they stand, and take them in and out of service.
   */
  OPERATE,
  /** Add, change and remove robots, floors, users, and whatever else the site has. */
  MANAGE,
  /** Make sites, look at all of them, and set what is of the whole server. */
  ADMINISTER
}
