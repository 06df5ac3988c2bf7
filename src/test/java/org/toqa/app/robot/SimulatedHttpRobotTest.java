package org.toqa.app.robot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.agent.chassis.Surroundings;
import org.toqa.geometry.Pose;
import org.toqa.link.http.HttpRobotCodec;
import org.toqa.link.http.RobotToken;
import org.toqa.link.http.WheelOrder;
import org.toqa.link.http.WheelReport;
import org.toqa.motion.DifferentialLimits;
import org.toqa.motion.WheelCommand;
import org.toqa.testbed.FaultyTcpProxy;

/** The client robot, asked as docs/http-robot.md says. */
@Timeout(60)
class SimulatedHttpRobotTest {
  private static final RobotToken TOKEN = new RobotToken("a-token-of-a-test");
  private static final DifferentialLimits LIMITS = new DifferentialLimits(0.52, 0.2, 0.5, 0.8, 4);

  /** Of the robot's time, from one order to the next. */
  private static final long STEP_NANOS = Duration.ofMillis(10).toNanos();

  @TempDir private Path folder;
  private final HttpClient http = HttpClient.newHttpClient();
  private SimulatedHttpRobot robot;

  @BeforeEach
  void start() throws IOException {
    robot = new SimulatedHttpRobot(SimulatedHttpRobot.Settings.of(TOKEN, new Pose(0, 0, 0)));
  }

  @AfterEach
  void close() {
    robot.close();
    http.close();
  }

  private HttpRequest.Builder request(String path) {
    return request(robot.port(), path);
  }

  private static HttpRequest.Builder request(int port, String path) {
    return HttpRequest.newBuilder(URI.create("http://127.0.0.1:" + port + path))
        .header("Authorization", "Bearer " + TOKEN.secret());
  }

  private HttpResponse<byte[]> send(HttpRequest.Builder request) throws Exception {
    return http.send(request.build(), BodyHandlers.ofByteArray());
  }

  private WheelReport order(long seq, double v, double w) throws Exception {
    return order(seq, null, v, w);
  }

  private WheelReport order(long seq, @Nullable Long after, double v, double w) throws Exception {
    return report(send(request("/v1/wheels").POST(body(seq, after, v, w))));
  }

  private static HttpRequest.BodyPublisher body(
      long seq, @Nullable Long after, double v, double w) {
    return BodyPublishers.ofByteArray(
        HttpRobotCodec.encode(WheelOrder.of(seq, after, WheelCommand.of(0, v, w, LIMITS))));
  }

  private static WheelReport report(HttpResponse<byte[]> answer) throws Exception {
    assertEquals(200, answer.statusCode());
    return HttpRobotCodec.decodeReport(answer.body());
  }

  @Test
  void whoeverHasNoTokenIsTurnedAway() throws Exception {
    HttpRequest.Builder without =
        HttpRequest.newBuilder(URI.create("http://127.0.0.1:" + robot.port() + "/v1/robot"));

    assertEquals(401, send(without).statusCode());
    assertEquals(401, send(without.header("Authorization", "Bearer another-token")).statusCode());
  }

  @Test
  void whatIsNotInTheBookIsRefused() throws Exception {
    assertEquals(404, send(request("/v1/arms")).statusCode());
    assertEquals(405, send(request("/v1/wheels")).statusCode());
    assertEquals(400, send(request("/v1/wheels").POST(BodyPublishers.ofString("{}"))).statusCode());
  }

  @Test
  void wheelsCountWhatTheyTurn() throws Exception {
    AtomicLong time = startWithClock();
    WheelReport first = order(1, 0.2, 0);
    WheelReport later = first;
    for (long seq = 2; later.left() < 1000; seq++) {
      assertTrue(seq < 1000, "they hardly turn");
      time.addAndGet(STEP_NANOS);
      later = order(seq, 0.2, 0);
    }

    // 2808 counts are a turn of 2 pi 0.04 m
    double metres = (later.left() - first.left()) * 2 * Math.PI * 0.04 / 2808;
    assertEquals(metres, robot.truePose().x(), 0.005);
    assertTrue(later.stamp() > first.stamp());
  }

  @Test
  void oldOrderHasNoEffect() throws Exception {
    order(7, 0, 0);

    WheelReport answer = order(7, 0.4, 0);
    order(3, 0.4, 0);

    assertEquals(7, answer.seq());
    assertEquals(0, robot.truePose().x());
  }

  /** Its connection brings it as soon as it can, with the highest number of all. */
  @ParameterizedTest
  @ValueSource(ints = {1, 5, 60})
  void orderThatWasHeldUpOnItsWayHasNoEffect(int seconds) throws Exception {
    AtomicLong time = startWithClock();
    try (FaultyTcpProxy cable = new FaultyTcpProxy(robot.port())) {
      long after = order(1, 0, 0).stamp();
      cable.silence();
      CompletableFuture<HttpResponse<byte[]>> held =
          http.sendAsync(
              request(cable.port(), "/v1/wheels").POST(body(2, after, 0.4, 0)).build(),
              BodyHandlers.ofByteArray());
      time.addAndGet(Duration.ofSeconds(seconds).toNanos());
      cable.mend();
      WheelReport answer = report(held.get(20, TimeUnit.SECONDS));
      time.addAndGet(Duration.ofSeconds(1).toNanos());

      assertEquals(1, answer.seq());
      assertEquals(0, robot.truePose().x());
      assertEquals(2, order(2, answer.stamp() + 1000, 0.4, 0).seq());
      time.addAndGet(Duration.ofSeconds(1).toNanos());
      assertTrue(robot.truePose().x() > 0.04);
    }
  }

  /** The robot has another clock than the one by which the order was sent. */
  @Test
  void orderOfAClockThatHasBegunAnewHasNoEffect() throws Exception {
    long stamp = order(1, 0, 0).stamp();

    assertEquals(1, order(2, stamp + 3_600_000, 0.4, 0).seq());

    assertEquals(0, robot.truePose().x());
  }

  /**
   * @return its clock, nanoseconds
   */
  private AtomicLong startWithClock() throws IOException {
    robot.close();
    AtomicLong time = new AtomicLong();
    robot =
        new SimulatedHttpRobot(
            SimulatedHttpRobot.Settings.of(TOKEN, new Pose(0, 0, 0)),
            Surroundings.EMPTY,
            time::get);
    return time;
  }

  /** Judged at the body: from 200 ms after the last order on it only brakes. */
  @Test
  void silenceStopsTheWheels() throws Exception {
    AtomicLong time = startWithClock();
    for (long seq = 1; robot.truePose().x() < 0.05; seq++) {
      assertTrue(seq < 1000, "it hardly drives");
      order(seq, 0.4, 0);
      time.addAndGet(STEP_NANOS);
    }
    double atLastOrder = robot.truePose().x();
    time.addAndGet(Duration.ofSeconds(2).toNanos());
    double stopped = robot.truePose().x();
    time.addAndGet(Duration.ofSeconds(2).toNanos());

    assertEquals(stopped, robot.truePose().x());
    // 0.2 s at 0.4 m/s and some centimetres to brake
    assertTrue(
        stopped - atLastOrder < 0.4 * 0.2 + 0.1, "it went on for " + (stopped - atLastOrder));
    assertTrue(stopped - atLastOrder > 0.04, "it stopped at once");
  }

  @Test
  void bodyThatIsKeptGoesOnCounting() throws Exception {
    SimulatedHttpRobot.Settings usual = SimulatedHttpRobot.Settings.of(TOKEN, new Pose(1, 2, 0));
    SimulatedHttpRobot.Settings kept =
        new SimulatedHttpRobot.Settings(
            usual.address(),
            0,
            TOKEN,
            null,
            folder,
            usual.start(),
            0,
            0,
            1,
            5,
            Duration.ZERO,
            List.of(),
            null);
    robot.close();
    robot = new SimulatedHttpRobot(kept);
    WheelReport first = order(1, 0.2, 0);
    for (long seq = 2; order(seq, 0.2, 0).left() <= first.left(); seq++) {
      TimeUnit.MILLISECONDS.sleep(10);
    }
    robot.close();
    robot = new SimulatedHttpRobot(kept);

    WheelReport later = order(1, 0, 0);

    assertEquals(first.boot(), later.boot());
    assertTrue(later.left() > first.left());
  }
}
