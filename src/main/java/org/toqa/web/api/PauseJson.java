package org.toqa.web.api;

import java.time.Instant;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FleetPause;

/** That all robots are paused, on the wire; the fields are those of {@link FleetPause}. */
record PauseJson(String user, Instant since) {

  static @Nullable PauseJson of(@Nullable FleetPause pause) {
    return pause == null ? null : new PauseJson(pause.user(), pause.since());
  }
}
