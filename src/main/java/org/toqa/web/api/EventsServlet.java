package org.toqa.web.api;

import jakarta.servlet.AsyncContext;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.toqa.web.access.Caller;

/** Live events: the fleet's snapshots as a stream. */
public final class EventsServlet extends ApiServlet {
  private final transient SnapshotEvents events = new SnapshotEvents();
  private final transient Set<Thread> streams = ConcurrentHashMap.newKeySet();

  @Override
  protected void doGet(HttpServletRequest request, HttpServletResponse response) {
    doHead(request, response);
    Caller caller = Caller.of(request);
    AsyncContext async = request.startAsync();
    async.setTimeout(0);
    EventStream stream = new EventStream(async, services(), caller, events);
    Thread.ofVirtual()
        .name("events of " + caller.name())
        .start(
            () -> {
              streams.add(Thread.currentThread());
              try {
                stream.run();
              } finally {
                streams.remove(Thread.currentThread());
              }
            });
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
}
