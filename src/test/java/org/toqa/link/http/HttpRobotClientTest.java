package org.toqa.link.http;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.toqa.motion.DifferentialLimits;
import org.toqa.motion.WheelCommand;

class HttpRobotClientTest {
  private static final int EXCHANGES = 2000;
  private static final RobotToken TOKEN = RobotToken.random();
  private static final WheelReport REPORT = new WheelReport(1, 1, 0, 0, 0, null, null, List.of());
  private static final WheelOrder ORDER =
      WheelOrder.of(1, WheelCommand.of(0, 0, 0, DifferentialLimits.DEFAULT));

  private static HttpServer start(WheelReport answer) throws IOException {
    HttpServer robot =
        HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
    robot.createContext(
        "/v1/wheels",
        exchange -> {
          byte[] report = HttpRobotCodec.encode(answer);
          exchange.getRequestBody().readAllBytes();
          exchange.sendResponseHeaders(200, report.length);
          exchange.getResponseBody().write(report);
          exchange.close();
        });
    robot.start();
    return robot;
  }

  /** By which the robot's counts are judged. */
  @Test
  void anAnswerThatIsThereHasTheTimeAtWhichItCame() throws Exception {
    HttpServer robot = start(REPORT);
    int port = robot.getAddress().getPort();
    try (HttpRobotClient client =
        new HttpRobotClient(new HttpRobotAddress("127.0.0.1", port, TOKEN, null))) {
      for (int i = 0; i < EXCHANGES; i++) {
        long before = System.nanoTime();
        HttpRobotClient.Exchange exchange = client.exchange(ORDER);
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

  /** The number after it would be none that a robot may take. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "4503599627370496 | seq is 4503599627370496, where 1 was sent last",
        "4503599627370497 | seq must be a whole number from 0 to 4503599627370496",
        "9007199254740992 | seq must be a whole number from 0 to 4503599627370496"
      })
  void numberFarAboveWhatWasSentMakesNoSense(long seq, String sentence) throws Exception {
    HttpServer robot = start(new WheelReport(seq, 1, 0, 0, 0, null, null, List.of()));
    int port = robot.getAddress().getPort();
    try (HttpRobotClient client =
        new HttpRobotClient(new HttpRobotAddress("127.0.0.1", port, TOKEN, null))) {
      HttpRobotClient.Exchange exchange = client.exchange(ORDER);
      assertTrue(exchange.await(Duration.ofSeconds(20)));

      HttpRobotException refused = assertThrows(HttpRobotException.class, exchange::report);

      assertEquals(HttpRobotException.Reason.NONSENSE, refused.reason());
      assertEquals(sentence, refused.getMessage());
    } finally {
      robot.stop(0);
    }
  }
}
