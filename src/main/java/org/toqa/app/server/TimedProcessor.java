package org.toqa.app.server;

import java.io.IOException;
import java.util.OptionalLong;
import org.apache.coyote.Adapter;
import org.apache.coyote.http11.AbstractHttp11Protocol;
import org.apache.coyote.http11.Http11Processor;
import org.apache.tomcat.util.net.AbstractEndpoint.Handler.SocketState;
import org.apache.tomcat.util.net.SocketWrapperBase;

/** Tells of the request that it reads since when it has been coming in. */
final class TimedProcessor extends Http11Processor {
  private final ReceivedRequests requests;

  TimedProcessor(AbstractHttp11Protocol<?> protocol, Adapter adapter, ReceivedRequests requests) {
    super(protocol, adapter);
    this.requests = requests;
  }

  @Override
  public SocketState service(SocketWrapperBase<?> connection) throws IOException {
    requests.begin(connection, this);
    int before = servedCount();
    SocketState state = SocketState.CLOSED;
    try {
      state = super.service(connection);
      return state;
    } finally {
      boolean isServed = servedCount() != before;
      boolean isParted =
          switch (state) {
            case LONG -> !isAsync(); // a part of the header
            case OPEN -> !isServed; // empty lines before it
            default -> false;
          };
      requests.end(connection, isParted, isServed);
    }
  }

  private int servedCount() {
    return request.getRequestProcessor().getRequestCount();
  }

  /** When the request began that is not complete; empty where there is none. */
  OptionalLong receivingSince() {
    long since = request.getStartTimeNanos();
    return since < 0 || isRequestBodyFullyRead() ? OptionalLong.empty() : OptionalLong.of(since);
  }
}
