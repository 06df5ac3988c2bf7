package org.toqa.web.live;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import org.toqa.accounts.AddressBlock;
import org.toqa.web.ConcurrencyLimit;
import org.toqa.web.ConcurrencyLimits;

/**
 * One stream's place among those of its user, of its address and of all. Closing it gives it up.
 */
final class StreamPlaces implements AutoCloseable {
  private record Place(ConcurrencyLimit limit, String holder) {}

  /** Why there is none: the key of a sentence about so many streams. */
  record Refusal(String key, int max) {}

  private final Deque<Place> held = new ArrayDeque<>();
  private final AtomicBoolean isHeld = new AtomicBoolean(true);

  /** Takes one place of each. */
  Optional<Refusal> take(ConcurrencyLimits limits, String user, String address) {
    if (!take(limits.streamsByUser(), user)) {
      return refuse("problem.tooManyStreamsOfUser", limits.streamsByUser());
    }
    if (!take(limits.streamsByAddress(), AddressBlock.of(address))) {
      return refuse("problem.tooManyStreamsOfAddress", limits.streamsByAddress());
    }
    return take(limits.streams(), "")
        ? Optional.empty()
        : refuse("problem.tooManyStreams", limits.streams());
  }

  private boolean take(ConcurrencyLimit limit, String holder) {
    boolean isTaken = limit.tryAcquire(holder);
    if (isTaken) {
      held.add(new Place(limit, holder));
    }
    return isTaken;
  }

  private Optional<Refusal> refuse(String key, ConcurrencyLimit limit) {
    close();
    return Optional.of(new Refusal(key, limit.max()));
  }

  @Override
  public void close() {
    if (isHeld.getAndSet(false)) {
      held.forEach(place -> place.limit().release(place.holder()));
    }
  }
}
