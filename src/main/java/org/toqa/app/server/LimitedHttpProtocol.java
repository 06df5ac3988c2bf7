package org.toqa.app.server;

import java.net.InetAddress;
import org.apache.coyote.Processor;
import org.apache.coyote.http11.Http11NioProtocol;
import org.jspecify.annotations.Nullable;
import org.toqa.app.config.Configuration.Limits;

/** HTTP/1.1 with the limits of {@link LimitedEndpoint}. */
final class LimitedHttpProtocol extends Http11NioProtocol {
  private final ReceivedRequests requests;

  private LimitedHttpProtocol(LimitedEndpoint endpoint) {
    super(endpoint);
    requests = endpoint.requests();
  }

  /**
   * @param proxy whose connections are not counted by address; null: there is none
   */
  static LimitedHttpProtocol of(Limits limits, @Nullable InetAddress proxy) {
    return new LimitedHttpProtocol(new LimitedEndpoint(limits, proxy));
  }

  @Override
  protected Processor createProcessor() {
    return new TimedProcessor(this, getAdapter(), requests);
  }
}
