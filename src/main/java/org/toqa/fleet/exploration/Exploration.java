package org.toqa.fleet.exploration;

import java.time.Instant;
import org.jspecify.annotations.Nullable;
import org.toqa.exploration.ExplorationOrder;
import org.toqa.exploration.ExplorationPicture;

/**
 * An exploration of a floor.
 *
 * @param ground over which it drives: as {@link Explorer#ground} reads it
 * @param user who started it
 * @param revision that the floor's draft had then
 * @param endedAt null: it goes on
 * @param draft what has become of what was seen
 */
public record Exploration(
    String floor,
    String ground,
    ExplorationOrder order,
    String user,
    long revision,
    Instant startedAt,
    @Nullable Instant endedAt,
    State state,
    ExplorationPicture picture,
    Draft draft) {

  /** How far it is, and how it ended. */
  public enum State {
    RUNNING,
    REACHED,
    NO_WAY,
    LOST,
    OUT_OF_TIME,
    /** By a person, or by the end of the server. */
    STOPPED,
    /** By a fault of the server. */
    FAILED,
    /** The server was killed, or its machine failed, in the middle of it. */
    INTERRUPTED;

    public boolean isOver() {
      return this != RUNNING;
    }
  }

  /** What has become of what was seen. */
  public enum Draft {
    /** It goes on. */
    NONE_YET,
    /** It is the floor's draft, or was. */
    SAVED,
    /** The floor has got another draft or map meanwhile, or could not be asked. */
    NOT_SAVED
  }

  Exploration with(State now, ExplorationPicture seen) {
    return new Exploration(
        floor, ground, order, user, revision, startedAt, endedAt, now, seen, draft);
  }

  /** The same; what was seen is the draft by now. */
  Exploration saved() {
    return new Exploration(
        floor, ground, order, user, revision, startedAt, endedAt, state, picture, Draft.SAVED);
  }

  Exploration ended(Instant at, Draft became) {
    return new Exploration(
        floor, ground, order, user, revision, startedAt, at, state, picture, became);
  }
}
