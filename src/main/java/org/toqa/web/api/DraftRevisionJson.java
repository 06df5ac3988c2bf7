package org.toqa.web.api;

import java.time.Instant;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FloorDraft;

/**
 * Which draft of a floor there is, on the wire.
 *
 * @param revision 0: there is no draft
 * @param user who changed it last
 */
record DraftRevisionJson(String floor, long revision, @Nullable String user, @Nullable Instant at) {
  static DraftRevisionJson of(FloorDraft draft) {
    return new DraftRevisionJson(draft.floor(), draft.revision(), draft.user(), draft.at());
  }
}
