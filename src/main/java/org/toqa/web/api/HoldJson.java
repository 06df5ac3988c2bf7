package org.toqa.web.api;

import java.time.Instant;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Hold;

/** That robots are on hold, on the wire; the fields are those of {@link Hold}. */
public record HoldJson(String user, Instant since) {

  static @Nullable public HoldJson of(@Nullable Hold hold) {
    return hold == null ? null : new HoldJson(hold.user(), hold.since());
  }
}
