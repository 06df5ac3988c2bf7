package org.toqa.agent.http;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.geometry.Twist;
import org.toqa.link.http.ExchangeListener;
import org.toqa.link.http.HttpRobotAddress;
import org.toqa.link.http.HttpRobotClient;
import org.toqa.link.http.HttpRobotCodec;
import org.toqa.link.http.HttpRobotException;
import org.toqa.link.http.RobotDescription;
import org.toqa.link.http.RobotToken;
import org.toqa.link.http.WheelOrder;
import org.toqa.link.http.WheelReport;
import org.toqa.link.http.WheelReport.RobotError;
import org.toqa.localisation.RangeSource;

/** What the server's end of a body over HTTP sends, and makes of the answers. */
@Timeout(60)
class HttpChassisTest {
  private static final long BOOT = 7;
  private static final long FIRST_STAMP = 1000;
  private static final RobotToken TOKEN = RobotToken.random();
  private static final RobotDescription BODY =
      new RobotDescription(0.2, 0.04, 2808, 0.52, 5, 0.255, false, List.of(), null, BOOT, 40);

  @TempDir private Path folder;
  private final List<WheelOrder> orders = new CopyOnWriteArrayList<>();
  private final AtomicLong stamp = new AtomicLong(FIRST_STAMP);

  /** So many it still gives. */
  private final Semaphore answers = new Semaphore(Integer.MAX_VALUE / 2);

  /** Of answers that are on their way. */
  private final Semaphore written = new Semaphore(0);

  /** The number of the order whose answer tells that it cannot drive. */
  private volatile long stoppedAt;

  private HttpServer robot;
  private HttpRobotClient client;

  @BeforeEach
  void start() throws IOException {
    robot = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
    robot.createContext("/v1/wheels", this::answer);
    robot.start();
    client =
        new HttpRobotClient(
            new HttpRobotAddress("127.0.0.1", robot.getAddress().getPort(), TOKEN, null));
  }

  @AfterEach
  void close() {
    client.close();
    robot.stop(0);
  }

  private void answer(HttpExchange exchange) throws IOException {
    WheelOrder order = HttpRobotCodec.decodeOrder(exchange.getRequestBody().readAllBytes());
    orders.add(order);
    answers.acquireUninterruptibly();
    byte[] report =
        HttpRobotCodec.encode(
            new WheelReport(
                order.seq(),
                BOOT,
                stamp.getAndAdd(30),
                0,
                0,
                null,
                null,
                order.seq() == stoppedAt
                    ? List.of(new RobotError("STALL", "Blocked."))
                    : List.of()));
    exchange.sendResponseHeaders(200, report.length);
    exchange.getResponseBody().write(report);
    exchange.close();
    written.release();
  }

  private HttpChassis open() throws IOException {
    return HttpChassis.open(
        client, BODY, new Listener(), RangeSource.NONE, folder.resolve("odometry"), 0);
  }

  private static final class Listener implements ExchangeListener {
    @Override
    public void answered(long nanos) {}

    @Override
    public void failed(HttpRobotException why) {}
  }

  /** So that a robot ignores what was held up on its way. */
  @Test
  void eachOrderTellsTheStampOfTheAnswerBeforeIt() throws Exception {
    try (HttpChassis chassis = open()) {
      while (orders.size() < 4) {
        chassis.exchange(new Twist(0.1, 0, 0), 0); // nothing is given up
      }
    }

    assertEquals(
        Arrays.asList(null, FIRST_STAMP, FIRST_STAMP + 30, FIRST_STAMP + 60),
        orders.stream().limit(4).map(WheelOrder::after).toList());
    assertEquals(0, orders.getFirst().left().speed());
    assertTrue(orders.get(1).left().speed() > 0);
  }

  /** Also where one tick takes two answers, of which the first alone tells it. */
  @Test
  void noStopOfItsOwnPassesUnseen() throws Exception {
    try (HttpChassis chassis = open()) {
      stoppedAt = BODY.seq() + 2;
      answers.drainPermits();
      chassis.exchange(new Twist(0.1, 0, 0), 0);
      answers.release(Integer.MAX_VALUE / 2);
      List<Boolean> stops = new ArrayList<>();
      while (orders.size() < 5) {
        stops.add(chassis.exchange(new Twist(0.1, 0, 0), 0).hasOwnStop());
      }

      assertTrue(stops.contains(true), stops.toString());
      assertFalse(stops.getLast(), stops.toString());
    }
  }

  /** Whose answer was due, so that nothing could be sent. */
  @Test
  void whoIsLeftWhileItDrivesIsToldToStand() throws Exception {
    try (HttpChassis chassis = open()) {
      answers.drainPermits();
      while (orders.size() < 2) {
        chassis.exchange(new Twist(0.1, 0, 0), 0);
      }
      chassis.exchange(Twist.ZERO, 0);
      assertEquals(2, orders.size());
      answers.release(Integer.MAX_VALUE / 2);
      // both are on their way: it waits for the second one no longer than it must
      assertTrue(written.tryAcquire(2, 10, TimeUnit.SECONDS));
    }

    assertTrue(orders.get(1).left().speed() > 0);
    assertEquals(3, orders.size());
    assertEquals(0, orders.get(2).left().speed());
    assertEquals(0, orders.get(2).right().speed());
  }
}
