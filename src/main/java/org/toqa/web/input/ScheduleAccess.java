package org.toqa.web.input;

import org.toqa.fleet.Schedule;
import org.toqa.web.access.Caller;

/** Who may change a schedule. */
public final class ScheduleAccess {
  private ScheduleAccess() {}

  /** A clerk changes his own schedules, an operator all. */
  public static boolean canChange(Caller caller, Schedule schedule) {
    return caller.mayChangeOrderOf(schedule.owner());
  }
}
