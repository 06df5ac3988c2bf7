package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.RobotView;
import org.toqa.store.Account;
import org.toqa.store.Secret;
import org.toqa.web.Texts;

/**
 * The version of what a call changes, so that nobody overwrites what somebody else has changed
 * since he read it (RFC 9110, If-Match). It goes by what can be changed, not by all that is told.
 */
record Version(String tag) {
  private static final int LENGTH = 16;

  static Version of(Account user) {
    return of(user.name(), user.email(), user.role(), user.disabled());
  }

  static Version of(RobotView robot) {
    return of(robot.host(), robot.port(), robot.maxLoad(), robot.parking());
  }

  private static Version of(@Nullable Object... parts) {
    return new Version('"' + Secret.hash(Arrays.deepToString(parts)).substring(0, LENGTH) + '"');
  }

  /**
   * @throws Problem.Raised when the caller means another version than this
   */
  void refuseOther(HttpServletRequest request) {
    String wanted = request.getHeader("If-Match");
    if (wanted != null
        && Arrays.stream(wanted.split(",", -1))
            .map(String::strip)
            .noneMatch(one -> one.equals("*") || one.equals(tag))) {
      throw Problem.of(412, Texts.of(request).get("problem.changedMeanwhile")).raised();
    }
  }
}
