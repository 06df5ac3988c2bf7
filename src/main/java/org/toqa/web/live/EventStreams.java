package org.toqa.web.live;

import jakarta.servlet.AsyncContext;
import jakarta.servlet.AsyncEvent;
import jakarta.servlet.AsyncListener;
import jakarta.servlet.ServletContext;
import java.util.Locale;
import java.util.Objects;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.jspecify.annotations.Nullable;
import org.toqa.accounts.Site;
import org.toqa.web.Metrics;
import org.toqa.web.Services;
import org.toqa.web.Sites;
import org.toqa.web.access.Caller;

/** The streams of live events that are open. Closing it ends them. */
public final class EventStreams implements AutoCloseable {
  /** The servlet context's attribute that holds them. */
  public static final String ATTRIBUTE = EventStreams.class.getName();

  private final EventWriters writers = new EventWriters();
  private final Set<Thread> threads = ConcurrentHashMap.newKeySet();

  public static EventStreams of(ServletContext context) {
    return (EventStreams)
        Objects.requireNonNull(
            context.getAttribute(ATTRIBUTE), "The event streams are not in the servlet context.");
  }

  /**
   * Writes events as the response of that request, until the reader has gone or may no longer see
   * them.
   *
   * @param changesOnly whether the reader puts snapshots together from what changed
   * @param withNotices whether the reader is told when there are other notices
   * @param floor the only one that is told of; null: all are
   * @param places are given up at its end
   * @param lastId what the reader says it has; an id that is none counts as nothing
   */
  void start(
      AsyncContext async,
      Sites sites,
      Services services,
      Caller caller,
      Locale locale,
      boolean changesOnly,
      boolean withNotices,
      @Nullable String floor,
      StreamPlaces places,
      @Nullable String lastId) {
    Thread thread =
        Thread.ofVirtual()
            .name("events of " + caller.name())
            .unstarted(
                new EventStream(
                    async,
                    sites,
                    services,
                    caller,
                    writers.writer(
                        services.site(), locale, floor, (site, one) -> isThere(sites, site, one)),
                    changesOnly,
                    withNotices,
                    floor,
                    lastId,
                    threads::size));
    async.addListener(new StreamEndListener(thread, places, services.metrics()));
    threads.add(thread);
    services.metrics().recordStreamStart();
    thread.start();
  }

  private static boolean isThere(Sites sites, Site site, @Nullable String floor) {
    return sites
        .find(site.id())
        .filter(found -> floor == null || found.fleet().snapshots(floor).isPresent())
        .isPresent();
  }

  @Override
  public void close() {
    threads.forEach(Thread::interrupt);
  }

  /** The container ended the request, perhaps because the reader has gone: so ends its thread. */
  private final class StreamEndListener implements AsyncListener {
    private final Thread thread;
    private final StreamPlaces places;
    private final Metrics metrics;

    StreamEndListener(Thread thread, StreamPlaces places, Metrics metrics) {
      this.thread = thread;
      this.places = places;
      this.metrics = metrics;
    }

    @Override
    public void onComplete(AsyncEvent event) {
      places.close();
      if (threads.remove(thread)) {
        metrics.recordStreamEnd();
      }
      thread.interrupt();
    }

    @Override
    public void onError(AsyncEvent event) {
      thread.interrupt();
    }

    @Override
    public void onTimeout(AsyncEvent event) {}

    @Override
    public void onStartAsync(AsyncEvent event) {}
  }
}
