package org.toqa.web.live;

import jakarta.servlet.AsyncContext;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.Optional;
import java.util.function.IntSupplier;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.SnapshotFeed;
import org.toqa.persistence.StoreException;
import org.toqa.web.Services;
import org.toqa.web.Sites;
import org.toqa.web.access.Caller;

/**
 * One reader's live events, on a virtual thread of its own: the newest snapshot each time it is
 * ready for one, so a slow browser skips and slows nobody. One that takes nothing at all is left by
 * the container after the connection's time-out.
 */
final class EventStream implements Runnable {
  /** Also how often the reader's right to see is asked again. */
  private static final Duration KEEP_ALIVE = Duration.ofSeconds(5);

  private static final Duration MIN_INTERVAL = Duration.ofMillis(100);

  /** A second, to all readers together: where there are many, each is sent fewer. */
  private static final int MAX_CHANGES_PER_SECOND = 2000;

  private static final int MAX_SNAPSHOTS_PER_SECOND = 800;

  private static final byte[] RETRY = "retry: 2000\n\n".getBytes(StandardCharsets.UTF_8);
  private static final byte[] ALIVE = "event: alive\ndata: {}\n\n".getBytes(StandardCharsets.UTF_8);

  /** The reader asks what they are: only it may have to wait for the database. */
  private static final byte[] NOTICES =
      "event: notices\ndata: {}\n\n".getBytes(StandardCharsets.UTF_8);

  private final AsyncContext async;
  private final Sites sites;
  private final Services services;
  private final Caller caller;
  private final SnapshotEventWriter events;
  private final boolean changesOnly;
  private final boolean withNotices;
  private final @Nullable String floor;
  private final @Nullable String lastId;
  private final IntSupplier readerCount;

  /**
   * @param changesOnly whether the reader puts snapshots together from what changed
   * @param withNotices whether the reader is told when there are other notices
   * @param floor the only one that is told of, whose end is that of the stream; null: all are
   * @param lastId what the reader says it has; an id that is none counts as nothing
   * @param readerCount how many there are
   */
  EventStream(
      AsyncContext async,
      Sites sites,
      Services services,
      Caller caller,
      SnapshotEventWriter events,
      boolean changesOnly,
      boolean withNotices,
      @Nullable String floor,
      @Nullable String lastId,
      IntSupplier readerCount) {
    this.async = async;
    this.sites = sites;
    this.services = services;
    this.caller = caller;
    this.events = events;
    this.changesOnly = changesOnly;
    this.withNotices = withNotices;
    this.floor = floor;
    this.lastId = lastId;
    this.readerCount = readerCount;
  }

  @Override
  public void run() {
    try {
      stream(async.getResponse().getOutputStream());
    } catch (IOException readerHasGone) {
      // nobody is left to tell
    } catch (StoreException rightUnknown) {
      // it comes back and is asked who it is
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      complete();
    }
  }

  private void complete() {
    try {
      async.complete();
    } catch (IllegalStateException containerWasFirst) {
      // it saw the reader go
    }
  }

  private void stream(OutputStream out) throws IOException, InterruptedException {
    Optional<SnapshotFeed> wanted =
        floor == null
            ? Optional.of(services.fleet().snapshots())
            : services.fleet().snapshots(floor);
    if (wanted.isEmpty()) {
      return;
    }
    SnapshotFeed feed = wanted.get();
    long notices = services.notices().version(); // before the reader knows that he is connected
    out.write(RETRY);
    FleetSnapshot sent = feed.latest();
    send(out, events.id(sent).equals(lastId) ? ALIVE : events.snapshotEvent(sent));
    long checked = System.nanoTime();
    while (true) {
      Thread.sleep(interval());
      FleetSnapshot newest = feed.awaitNewer(sent.version(), KEEP_ALIVE);
      if (System.nanoTime() - checked >= KEEP_ALIVE.toNanos()) {
        if (!mayStillSee() || isFloorGone()) {
          return;
        }
        checked = System.nanoTime();
      }
      send(out, newest.version() > sent.version() ? event(sent, newest) : ALIVE);
      sent = newest;
      long latest = services.notices().version();
      if (withNotices && latest != notices) {
        send(out, NOTICES);
        notices = latest;
      }
    }
  }

  private boolean mayStillSee() {
    return caller
        .credential()
        .loginWithoutUse(sites)
        .filter(login -> !caller.isVisitor() || login.account().isAdministrator())
        .isPresent();
  }

  private boolean isFloorGone() {
    return floor != null && services.fleet().snapshots(floor).isEmpty();
  }

  private byte[] event(FleetSnapshot sent, FleetSnapshot newest) {
    return changesOnly ? events.changeEvent(sent, newest) : events.snapshotEvent(newest);
  }

  private Duration interval() {
    int maxPerSecond = changesOnly ? MAX_CHANGES_PER_SECOND : MAX_SNAPSHOTS_PER_SECOND;
    Duration fair = Duration.ofSeconds(readerCount.getAsInt()).dividedBy(maxPerSecond);
    return fair.compareTo(MIN_INTERVAL) > 0 ? fair : MIN_INTERVAL;
  }

  private static void send(OutputStream out, byte[] event) throws IOException {
    out.write(event);
    out.flush();
  }
}
