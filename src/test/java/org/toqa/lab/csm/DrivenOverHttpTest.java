package org.toqa.lab.csm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Objects;
import java.util.SplittableRandom;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.agent.chassis.Chassis;
import org.toqa.agent.chassis.ChassisCommand.DrivePath;
import org.toqa.agent.chassis.ChassisReading;
import org.toqa.agent.chassis.PathProgress;
import org.toqa.agent.drive.PaceLimits;
import org.toqa.agent.http.HttpChassis;
import org.toqa.driving.DrivenLine;
import org.toqa.geometry.Angles;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;
import org.toqa.lab.experiment.Run;
import org.toqa.link.http.ExchangeListener;
import org.toqa.link.http.HttpRobotAddress;
import org.toqa.link.http.HttpRobotClient;
import org.toqa.link.http.HttpRobotCodec;
import org.toqa.link.http.HttpRobotException;
import org.toqa.link.http.RobotDescription;
import org.toqa.link.http.RobotToken;
import org.toqa.link.http.WheelOrder;
import org.toqa.link.http.WheelReport;
import org.toqa.localisation.RangeSource;
import org.toqa.motion.BiarcFitter;
import org.toqa.motion.DriveSpeeds;
import org.toqa.motion.Odometry;
import org.toqa.motion.Segment;
import org.toqa.motion.Trajectory;
import org.toqa.motion.WheelCommand;
import org.toqa.planning.smooth.DiscSpace;
import org.toqa.planning.smooth.SmoothMethod;
import org.toqa.planning.smooth.curve.SmoothCurve;
import org.toqa.planning.smooth.curve.SplineFitter;

/**
 * The paper's three paths as the server drives them: {@link HttpChassis} with the segments of the
 * curves, and the laboratory's body behind HTTP. Time is simulated in steps of 30 ms, so that an
 * answer that is 40 ms late is there at the second tick after its order.
 */
@Tag("full")
@Timeout(120)
class DrivenOverHttpTest {
  private static final long SAMPLE_MILLIS = 30;
  private static final int LATE_SAMPLES = 2;

  /** A robot is compared with where its reference was then. */
  private static final int FOLLOWED_SAMPLES = 3;

  private static final int MOST_SAMPLES = 2000;
  private static final RobotToken TOKEN = RobotToken.random();
  private static final Pose ORIGIN = new Pose(0, 0, 0);
  private static final RobotDescription ROBOT =
      new RobotDescription(
          CsmParameters.LIMITS.track(),
          TwoWheelBody.WHEEL_RADIUS,
          Odometry.COUNTS_PER_WHEEL_TURN,
          CsmParameters.LIMITS.wheelSpeed(),
          5,
          0.2,
          false,
          List.of(),
          null,
          1,
          0);

  @TempDir private Path folder;
  private final Semaphore received = new Semaphore(0);
  private final Semaphore released = new Semaphore(0);
  private final Semaphore answered = new Semaphore(0);
  private HttpServer server;
  private TwoWheelBody body;
  private long sample;
  private volatile @Nullable WheelOrder order;

  @BeforeEach
  void start() throws IOException {
    server = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
    server.createContext("/v1/wheels", this::answer);
    server.start();
  }

  @AfterEach
  void stop() {
    released.release(MOST_SAMPLES);
    server.stop(0);
  }

  /** Obeys at once, and answers when it is let. */
  private void answer(HttpExchange exchange) throws IOException {
    WheelOrder told = HttpRobotCodec.decodeOrder(exchange.getRequestBody().readAllBytes());
    int[] counts = body.counts();
    long stamp = sample * SAMPLE_MILLIS;
    order = told;
    received.release();
    released.acquireUninterruptibly();
    byte[] report =
        HttpRobotCodec.encode(
            new WheelReport(told.seq(), 1, stamp, counts[0], counts[1], null, null, List.of()));
    exchange.sendResponseHeaders(200, report.length);
    exchange.getResponseBody().write(report);
    exchange.close();
    answered.release();
  }

  /**
   * The most on the way, by the answers.
   *
   * @param aside metres beside the curve
   * @param behind metres from the reference that it follows
   * @param heading radians from that
   */
  private record Errors(double aside, double behind, double heading) {}

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3})
  void theServersRobotStaysOnItsPathByItsAnswers(int number) throws Exception {
    CsmFloor floor = CsmFloor.read(number);
    DiscSpace space = DiscSpace.of(floor.grid(), 0.1);
    PlannedPath planned = PlannedPath.of(SmoothMethod.HYBRID, space, floor, 2000, number);
    SmoothCurve curve =
        new SplineFitter(space).fit(Objects.requireNonNull(planned.path()).points());

    Errors errors = drive(curve, number);

    assertTrue(errors.aside() < 0.01, errors::toString);
    assertTrue(errors.behind() < 0.015, errors::toString);
    assertTrue(errors.heading() < 0.1, errors::toString);
    assertEquals(0, body.answer().position().distanceTo(floor.goal()), 0.01);
  }

  private Errors drive(SmoothCurve curve, int seed) throws Exception {
    Vec2 from = curve.pieces().getFirst().position(0);
    double first = curve.pieces().getFirst().velocity(0).angle();
    Pose start = new Pose(from.x(), from.y(), first);
    List<Segment> segments =
        new BiarcFitter(DriveSpeeds.DEFAULT).fit(first, curve.pieces()).segments();
    Trajectory planned = new Trajectory(start, segments);
    DrivenLine line = DrivenLine.of(curve.pieces());
    body =
        new TwoWheelBody(
            start,
            CsmParameters.LIMITS,
            CsmParameters.faults(Run.of(1, 1)),
            new SplittableRandom(seed));
    double aside = 0;
    double behind = 0;
    double heading = 0;
    Listener listener = new Listener();
    released.release();
    try (HttpRobotClient client =
            new HttpRobotClient(
                new HttpRobotAddress("127.0.0.1", server.getAddress().getPort(), TOKEN, null));
        HttpChassis chassis =
            HttpChassis.open(
                client, ROBOT, listener, RangeSource.NONE, folder.resolve("odometry"), 0)) {
      received.acquire();
      answered.acquire();
      Deque<Long> due = new ArrayDeque<>();
      Deque<Pose> references = new ArrayDeque<>();
      PathProgress progress = new PathProgress(1, 0, 0, 0, false);
      for (sample = 1; sample < MOST_SAMPLES && !isAtEnd(progress, segments); sample++) {
        if (!due.isEmpty() && due.getFirst() <= sample) {
          due.removeFirst();
          released.release();
          assertTrue(answered.tryAcquire(20, TimeUnit.SECONDS));
        }
        boolean wasFree = due.isEmpty();
        ChassisReading reading;
        do { // again where a busy machine has not brought the answer within the tick
          reading =
              chassis.exchange(
                  command(segments, progress.completed()), sample * SAMPLE_MILLIS * 1_000_000);
        } while (wasFree && !received.tryAcquire(100, TimeUnit.MILLISECONDS));
        if (wasFree) {
          due.add(sample + LATE_SAMPLES);
        }
        progress = Objects.requireNonNull(reading.progress());
        references.addLast(reference(planned, progress));
        Pose reference =
            references.size() > FOLLOWED_SAMPLES ? references.removeFirst() : references.getFirst();
        Pose now = body.answer();
        aside = Math.max(aside, line.distanceTo(now.position()));
        heading = Math.max(heading, turn(reference, now));
        behind = Math.max(behind, reference.distanceTo(now));
        body.drive(command(Objects.requireNonNull(order)));
      }
    }
    return new Errors(aside, behind, heading);
  }

  /** Radians. */
  private static double turn(Pose from, Pose to) {
    return Math.abs(Angles.difference(from.theta(), to.theta()));
  }

  private static boolean isAtEnd(PathProgress progress, List<Segment> segments) {
    return progress.settled() && progress.completed() == segments.size();
  }

  private static DrivePath command(List<Segment> segments, int from) {
    List<Segment> next =
        segments.subList(from, Math.min(segments.size(), from + Chassis.QUEUE_LENGTH));
    PaceLimits limits = new PaceLimits(0.5, 3, 0.15, 0.8); // of a robot over HTTP, alone
    return new DrivePath(1, ORIGIN, 0, limits, from, next, true);
  }

  private static WheelCommand command(WheelOrder told) {
    double left = told.left().speed();
    double right = told.right().speed();
    return WheelCommand.of(
        0, (left + right) / 2, (right - left) / ROBOT.track(), CsmParameters.LIMITS);
  }

  private static Pose reference(Trajectory planned, PathProgress progress) {
    Pose begun = planned.poseAfter(progress.completed());
    if (progress.completed() == planned.segments().size()) {
      return begun;
    }
    Segment now = planned.segments().get(progress.completed());
    return begun.advanced(new Twist(now.v(), 0, now.w()), progress.seconds());
  }

  private static final class Listener implements ExchangeListener {
    @Override
    public void answered(long nanos) {}

    @Override
    public void failed(HttpRobotException why) {
      throw new AssertionError(why);
    }
  }
}
