package org.toqa.web.input;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import org.toqa.accounts.Account;
import org.toqa.accounts.Secret;
import org.toqa.fleet.RobotRecord;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.Schedule;
import org.toqa.fleet.TaskTemplate;
import org.toqa.fleet.TaskView;
import org.toqa.mission.TransportTask;

/**
 * The version of what people change, so that nobody overwrites what somebody else has changed since
 * he read it. It goes by what can be changed, not by all that is told.
 */
public record Version(String text) {
  private static final int LENGTH = 16;

  public static Version of(Account user) {
    return of(user.name(), user.email(), user.role(), user.disabled());
  }

  public static Version of(RobotView robot) {
    RobotRecord stored = robot.record();
    return of(stored.host(), stored.port(), robot.maxLoad(), stored.parking(), stored.gateway());
  }

  /** Of all that is ordered of the task, not of its priority alone. */
  public static Version ofOrder(TaskView task) {
    TransportTask t = task.task();
    return of(
        t.name(),
        t.load(),
        t.start(),
        t.goal(),
        t.floor(),
        t.priority(),
        t.deadline(),
        t.size(),
        t.onlyRobots(),
        t.stops());
  }

  public static Version of(TaskView task) {
    return of(task.task().priority());
  }

  public static Version of(Schedule schedule) {
    return of(schedule.paused());
  }

  public static Version of(TaskTemplate template) {
    return of(template.changedAt());
  }

  private static Version of(@Nullable Object... parts) {
    return new Version(Secret.hash(Arrays.deepToString(parts)).substring(0, LENGTH));
  }

  /** As the header ETag has it. */
  public String tag() {
    return '"' + text + '"';
  }

  /** Whether it is one of those that a header If-Match names (RFC 9110). */
  public boolean isAmong(String ifMatch) {
    return Arrays.stream(ifMatch.split(",", -1))
        .map(String::strip)
        .anyMatch(one -> one.equals("*") || one.equals(tag()));
  }
}
