package org.toqa.web.live;

import jakarta.servlet.AsyncContext;
import jakarta.servlet.AsyncEvent;
import jakarta.servlet.AsyncListener;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.util.Arrays;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.toqa.web.Language;
import org.toqa.web.Metrics;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.api.ApiServlet;
import org.toqa.web.api.Problem;

/** Live events: the fleet's snapshots as a stream. */
public final class EventsServlet extends ApiServlet {
  private final transient Map<Locale, SnapshotEventWriter> events =
      Arrays.stream(Language.values())
          .map(Language::locale)
          .collect(Collectors.toMap(Function.identity(), SnapshotEventWriter::new));
  private final transient Set<Thread> streams = ConcurrentHashMap.newKeySet();

  @Override
  protected void doGet(HttpServletRequest request, HttpServletResponse response) {
    boolean isOfChanges = wantsChangesOnly(request);
    doHead(request, response);
    Caller caller = Caller.of(request);
    AsyncContext async = request.startAsync();
    async.setTimeout(0);
    Thread thread =
        Thread.ofVirtual()
            .name("events of " + caller.name())
            .unstarted(
                new EventStream(
                    async,
                    services(),
                    caller,
                    Objects.requireNonNull(events.get(Texts.of(request).locale())),
                    isOfChanges,
                    request.getHeader("Last-Event-ID"),
                    streams::size));
    Metrics metrics = services().metrics();
    async.addListener(new StreamEndListener(thread, metrics));
    streams.add(thread);
    metrics.recordStreamStart();
    thread.start();
  }

  private static boolean wantsChangesOnly(HttpServletRequest request) {
    return switch (Objects.requireNonNullElse(request.getParameter("changes"), "false")) {
      case "true" -> true;
      case "false" -> false;
      default ->
          throw Problem.of(400, Texts.of(request).get("problem.queryFlag", "changes")).exception();
    };
  }

  @Override
  protected void doHead(HttpServletRequest request, HttpServletResponse response) {
    response.setContentType("text/event-stream");
    response.setCharacterEncoding("UTF-8");
    response.setHeader("Cache-Control", "no-store, no-transform");
    response.setHeader("X-Accel-Buffering", "no");
  }

  @Override
  public void destroy() {
    streams.forEach(Thread::interrupt);
  }

  /** The container ended the request, perhaps because the reader has gone: so ends its thread. */
  private final class StreamEndListener implements AsyncListener {
    private final Thread thread;
    private final Metrics metrics;

    StreamEndListener(Thread thread, Metrics metrics) {
      this.thread = thread;
      this.metrics = metrics;
    }

    @Override
    public void onComplete(AsyncEvent event) {
      if (streams.remove(thread)) {
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
