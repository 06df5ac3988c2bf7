package org.toqa.link.http;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.net.httpserver.HttpServer;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.toqa.motion.DifferentialLimits;
import org.toqa.motion.WheelCommand;

class HttpRobotClientTest {
  private static final int EXCHANGES = 2000;
  private static final RobotToken TOKEN = RobotToken.random();
  private static final WheelReport REPORT = new WheelReport(1, 1, 0, 0, 0, null, null, List.of());

  /** By which the robot's counts are judged. */
  @Test
  void anAnswerThatIsThereHasTheTimeAtWhichItCame() throws Exception {
    HttpServer robot =
        HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
    robot.createContext(
        "/v1/wheels",
        exchange -> {
          byte[] report = HttpRobotCodec.encode(REPORT);
          exchange.getRequestBody().readAllBytes();
          exchange.sendResponseHeaders(200, report.length);
          exchange.getResponseBody().write(report);
          exchange.close();
        });
    robot.start();
    WheelOrder order = WheelOrder.of(1, WheelCommand.of(0, 0, 0, DifferentialLimits.DEFAULT));
    int port = robot.getAddress().getPort();
    try (HttpRobotClient client =
        new HttpRobotClient(new HttpRobotAddress("127.0.0.1", port, TOKEN, null))) {
      for (int i = 0; i < EXCHANGES; i++) {
        long before = System.nanoTime();
        HttpRobotClient.Exchange exchange = client.exchange(order);
        assertTrue(exchange.await(Duration.ofSeconds(20)));
        long ended = exchange.ended();
        assertEquals(REPORT, exchange.report());
        assertTrue(before <= exchange.begun() && exchange.begun() < ended);
        assertTrue(ended <= System.nanoTime());
      }
    } finally {
      robot.stop(0);
    }
  }
}
