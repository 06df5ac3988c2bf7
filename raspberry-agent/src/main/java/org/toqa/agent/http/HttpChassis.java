package org.toqa.agent.http;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.agent.chassis.Chassis;
import org.toqa.agent.chassis.ChassisCommand;
import org.toqa.agent.chassis.ChassisCommand.DrivePath;
import org.toqa.agent.chassis.ChassisCommand.MoveAt;
import org.toqa.agent.chassis.ChassisReading;
import org.toqa.agent.chassis.SegmentQueue;
import org.toqa.avoidance.RangeSensors;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.link.http.ExchangeListener;
import org.toqa.link.http.HttpRobotClient;
import org.toqa.link.http.HttpRobotException;
import org.toqa.link.http.HttpRobotException.Reason;
import org.toqa.link.http.RobotDescription;
import org.toqa.link.http.WheelOrder;
import org.toqa.link.http.WheelReport;
import org.toqa.link.http.WheelReport.RobotError;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.localisation.RangeSource;
import org.toqa.motion.DifferentialLimits;
import org.toqa.motion.DriveKind;
import org.toqa.motion.WheelCommand;

/**
 * A body on two wheels that takes their speeds over HTTP and answers with their counts. Every 30 ms
 * (CSM-MAMRS) it is steered along its path by the pose that its answers give. One order is under
 * way at a time; an answer that is late is waited for in the ticks that follow, and given up in the
 * end.
 */
public final class HttpChassis implements Chassis {
  private static final Logger log = LoggerFactory.getLogger(HttpChassis.class);

  private static final Duration PERIOD = Duration.ofMillis(Math.round(WheelCommand.SAMPLE * 1000));

  /** Within a tick. */
  private static final Duration ANSWER_WAIT = Duration.ofMillis(14);

  private static final Duration FIRST_ANSWER_WAIT = Duration.ofSeconds(1);

  /** The robot has stopped by itself then. */
  private static final long SILENT_NANOS = COMMAND_LIFE_NANOS;

  private static final double LONGEST_STEP_SECONDS = 0.1;

  /** Of a robot that has range sensors and does not say where they look. */
  private static final int USUAL_SENSORS = 3;

  /** How long what is wrong with counts or numbers is told. */
  private static final long TELLING_NANOS = 3_000_000_000L;

  private static final Fault JUMPED =
      new Fault(
          "WHEEL_COUNTS",
          "The counts of the robot's wheels have jumped by more than they can turn: nobody knows"
              + " where it is.");

  private static final Fault LOST =
      new Fault(
          "PLACE_LOST",
          "Most of what its range sensors measure does not fit the map where the robot took itself"
              + " to be: nobody knows where it is.");

  private static final Fault CONTESTED =
      new Fault("OTHER_SERVER", "Another program commands the wheels of this robot too.");

  private static final Fault BLIND =
      new Fault(
          "RANGE_SENSORS",
          "The robot says that it has range sensors, and does not tell a range of each.");

  private final HttpRobotClient robot;
  private final RobotDescription body;
  private final ExchangeListener listener;
  private final DifferentialLimits limits;
  private final CountedOdometry odometry;

  /** Null where its place is not corrected by ranges. */
  private final @Nullable PoseCorrection correction;

  private WheelReport report;

  /** What it told since the last reading, so that none passes unseen. */
  private List<RobotError> errors;

  private long seq;

  /** Null while no answer is awaited. */
  private HttpRobotClient.@Nullable Exchange underWay;

  private long sentNanos;

  /** What was sent last. */
  private Twist ordered = Twist.ZERO;

  /** What was sent with the order that is answered, from where the robot was then. */
  private Twist driven = Twist.ZERO;

  private long drivenSince;
  private long answeredNanos;
  private long lastNanos;
  private @Nullable HttpRobotException failure;
  private long jumpedUntil;
  private long lostUntil;
  private long contestedUntil;
  private Twist velocity = Twist.ZERO;

  /** Null while it drives by a velocity. */
  private @Nullable SegmentQueue queue;

  /** The number of the last path that it began. */
  private long lastPath;

  /**
   * Tells the robot to stand, and takes its first answer.
   *
   * @param odometryFile goes on with what is in it
   * @param ranges that it publishes; taken where it has told of its sonar
   * @param nanos now, on the daemon's monotonic clock
   * @throws IOException the robot does not answer, or the file cannot be used
   */
  public static HttpChassis open(
      HttpRobotClient robot,
      RobotDescription body,
      ExchangeListener listener,
      RangeSource ranges,
      Path odometryFile,
      long nanos)
      throws IOException {
    WheelOrder stop = WheelOrder.of(body.seq() + 1, command(Twist.ZERO, limitsOf(body)));
    HttpRobotClient.Exchange first = robot.exchange(stop);
    if (!first.await(FIRST_ANSWER_WAIT)) {
      first.cancel();
    }
    WheelReport report = first.report();
    CountedOdometry odometry = new CountedOdometry(odometryFile, body);
    odometry.update(report, first.begun(), first.ended());
    RobotDescription.Sonar sonar = body.sonar();
    PoseCorrection correction = sonar == null ? null : new PoseCorrection(ranges, body, sonar);
    return new HttpChassis(robot, body, listener, correction, odometry, report, nanos);
  }

  private HttpChassis(
      HttpRobotClient robot,
      RobotDescription body,
      ExchangeListener listener,
      @Nullable PoseCorrection correction,
      CountedOdometry odometry,
      WheelReport report,
      long nanos) {
    this.robot = robot;
    this.body = body;
    this.listener = listener;
    this.correction = correction;
    this.limits = limitsOf(body);
    this.odometry = odometry;
    this.report = report;
    errors = report.errors();
    seq = report.seq();
    answeredNanos = nanos;
    drivenSince = nanos;
    lastNanos = nanos;
    jumpedUntil = nanos;
    lostUntil = nanos;
    contestedUntil = nanos;
  }

  private static DifferentialLimits limitsOf(RobotDescription body) {
    DifferentialLimits usual = DifferentialLimits.DEFAULT;
    return new DifferentialLimits(
        body.maxSpeed(),
        body.track(),
        usual.acceleration(),
        usual.lateralAcceleration(),
        usual.jerk());
  }

  private static WheelCommand command(Twist twist, DifferentialLimits limits) {
    return WheelCommand.of(0, twist.vx(), twist.w(), limits);
  }

  @Override
  public Duration period() {
    return PERIOD;
  }

  @Override
  public ChassisReading exchange(ChassisCommand command, long nanos) {
    double seconds = Math.clamp((nanos - lastNanos) / 1e9, 0, LONGEST_STEP_SECONDS);
    lastNanos = nanos;
    awaitAnswer(nanos);
    correct(nanos);
    take(command);
    SegmentQueue path = queue;
    Twist wanted = path == null ? velocity : path.steer(predicted(nanos), seconds);
    if (underWay == null) {
      send(wanted, nanos);
      awaitAnswer(nanos);
    }
    return reading(nanos);
  }

  /**
   * Where the robot is as it gets the next order: its answer tells where it was as it got the one
   * before (O. J. M. Smith, "Closer control of loops with dead time", 1957).
   */
  private Pose predicted(long nanos) {
    Pose answered = odometry.pose();
    if (underWay == null) {
      return answered.advanced(driven, secondsBetween(drivenSince, nanos));
    }
    return answered
        .advanced(driven, secondsBetween(drivenSince, sentNanos))
        .advanced(ordered, secondsBetween(sentNanos, nanos));
  }

  /** At most as long as an order is obeyed. */
  private static double secondsBetween(long from, long to) {
    return Math.clamp(to - from, 0, COMMAND_LIFE_NANOS) / 1e9;
  }

  @Override
  public void setAnchor(@Nullable Pose anchor) {
    if (correction != null) {
      correction.setAnchor(anchor);
    }
  }

  private void correct(long nanos) {
    if (correction == null) {
      return;
    }
    correction.correct(odometry.pose(), odometry.twist()).ifPresent(odometry::setPose);
    if (correction.isLost()) {
      log.warn("A robot over HTTP has lost itself: what it measures does not fit the map.");
      odometry.beginAnew();
      standAnywhere();
      lostUntil = nanos + TELLING_NANOS;
    }
  }

  /** Nobody knows where it is. */
  private void standAnywhere() {
    queue = null;
    velocity = Twist.ZERO;
    setAnchor(null);
  }

  private void take(ChassisCommand command) {
    SegmentQueue driven = queue;
    switch (command) {
      case MoveAt(Twist wanted) -> {
        queue = null;
        velocity = wanted;
      }
      case DrivePath path when driven != null && driven.path() == path.number() ->
          driven.take(path);
      case DrivePath path when path.number() > lastPath -> {
        queue = new SegmentQueue(path, DriveKind.DIFFERENTIAL);
        lastPath = path.number();
      }
      case DrivePath _ -> {} // it was dropped
    }
  }

  private void send(Twist wanted, long nanos) {
    seq++;
    WheelCommand command = command(wanted, limits);
    ordered = new Twist(command.v(), 0, command.w());
    underWay = robot.exchange(WheelOrder.of(seq, report.stamp(), command));
    sentNanos = nanos;
  }

  /** Waits for it a little, and takes it if it is there. */
  private void awaitAnswer(long nanos) {
    HttpRobotClient.Exchange exchange = underWay;
    if (exchange == null) {
      return;
    }
    boolean isDone = exchange.await(ANSWER_WAIT);
    if (!isDone && nanos - sentNanos < SILENT_NANOS) {
      return;
    }
    underWay = null;
    try {
      if (!isDone) {
        exchange.cancel();
      }
      take(exchange, nanos);
    } catch (HttpRobotException e) {
      odometry.miss(exchange.ended());
      failure = e;
      listener.failed(e);
    }
  }

  private void take(HttpRobotClient.Exchange exchange, long nanos) throws HttpRobotException {
    WheelReport answer = exchange.report();
    report = answer;
    if (!answer.errors().isEmpty()) {
      errors = answer.errors();
    }
    answeredNanos = nanos;
    driven = ordered;
    drivenSince = sentNanos;
    failure = null;
    listener.answered(exchange.ended() - exchange.begun());
    if (answer.seq() > seq && answer.boot() == body.boot()) {
      contestedUntil = nanos + TELLING_NANOS;
    }
    seq = Math.max(seq, answer.seq());
    CountedOdometry.Outcome outcome = odometry.update(answer, exchange.begun(), exchange.ended());
    if (outcome != CountedOdometry.Outcome.CONTINUED) {
      standAnywhere();
      log.warn("Counts of a robot over HTTP: {} ({}).", outcome, answer);
    }
    if (outcome == CountedOdometry.Outcome.JUMPED) {
      jumpedUntil = nanos + TELLING_NANOS;
    }
  }

  private ChassisReading reading(long nanos) {
    boolean isSilent = nanos - answeredNanos >= SILENT_NANOS;
    List<RobotError> told = errors;
    errors = report.errors();
    return new ChassisReading(
        odometry.epoch(),
        null,
        odometry.pose(),
        isSilent ? Twist.ZERO : odometry.twist(),
        report.battery() == null ? 1 : report.battery(),
        ranges(),
        faults(nanos, isSilent, told),
        null, // it has no scale
        queue == null ? null : queue.progress(),
        null,
        !told.isEmpty());
  }

  private List<Double> ranges() {
    List<Double> told = report.ranges();
    return !body.hasRangeSensors() || told == null || isBlind()
        ? List.of()
        : told.stream()
            .map(range -> Math.clamp(range, RangeSensors.NEAREST, RangeSensors.FARTHEST))
            .toList();
  }

  /** Whether it does not tell what it should of each sensor. */
  private boolean isBlind() {
    List<Double> told = report.ranges();
    int sensors = body.rangeAngles().isEmpty() ? USUAL_SENSORS : body.rangeAngles().size();
    return told == null || told.size() != sensors;
  }

  private List<Fault> faults(long nanos, boolean isSilent, List<RobotError> told) {
    List<Fault> faults = new ArrayList<>();
    if (isSilent) {
      faults.add(silence());
    }
    if (nanos - jumpedUntil < 0) {
      faults.add(JUMPED);
    }
    if (nanos - lostUntil < 0) {
      faults.add(LOST);
    }
    if (nanos - contestedUntil < 0) {
      faults.add(CONTESTED);
    }
    if (body.hasRangeSensors() && isBlind()) {
      faults.add(BLIND);
    }
    told.forEach(error -> faults.add(new Fault(error.code(), error.text())));
    return faults;
  }

  private Fault silence() {
    HttpRobotException why = failure;
    return why != null && why.reason() == Reason.NONSENSE
        ? new Fault("CHASSIS_LINK", "The robot's answers make no sense: " + why.getMessage() + ".")
        : new Fault(
            "CHASSIS_SILENT",
            why == null
                ? "The robot does not answer its orders."
                : "The robot does not answer its orders: " + why.getMessage() + ".");
  }

  /**
   * Tells it to stand, also where that had to wait for an answer; a silent one stands by itself.
   */
  @Override
  public void close() {
    Duration limit = Duration.ofNanos(SILENT_NANOS);
    if (underWay != null && !ordered.equals(Twist.ZERO) && underWay.await(limit)) {
      awaitAnswer(lastNanos);
      send(Twist.ZERO, lastNanos);
    }
    if (underWay != null) {
      underWay.await(limit);
      underWay.cancel();
    }
    odometry.close();
  }
}
