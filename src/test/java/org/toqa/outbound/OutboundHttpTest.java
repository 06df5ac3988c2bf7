package org.toqa.outbound;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.net.InetAddress;
import java.net.ServerSocket;
import java.time.Duration;
import org.apache.hc.client5.http.SystemDefaultDnsResolver;
import org.apache.hc.client5.http.classic.methods.HttpGet;
import org.apache.hc.core5.http.ClassicHttpResponse;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

class OutboundHttpTest {
  @Test
  @Timeout(60)
  void aRequestThatIsEndedHereSaysSo() throws Exception {
    Duration whole = Duration.ofMillis(200);
    try (ServerSocket silent = new ServerSocket(0, 5, InetAddress.getLoopbackAddress());
        OutboundHttp http =
            new OutboundHttp(
                "test", Duration.ofMinutes(5), whole, 1, SystemDefaultDnsResolver.INSTANCE)) {
      HttpGet request = new HttpGet("http://127.0.0.1:" + silent.getLocalPort() + "/");

      OutboundHttp.WholeLimitException late =
          assertThrows(
              OutboundHttp.WholeLimitException.class,
              () -> http.send(request, ClassicHttpResponse::getCode));

      assertEquals(whole, late.limit());
    }
  }
}
