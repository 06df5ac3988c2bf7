package org.toqa.agent.firmware;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.agent.chassis.ArmDrive;
import org.toqa.agent.chassis.Chassis;
import org.toqa.agent.chassis.ChassisCommand;
import org.toqa.agent.chassis.ChassisCommand.DrivePath;
import org.toqa.agent.chassis.ChassisCommand.MoveAt;
import org.toqa.agent.chassis.ChassisReading;
import org.toqa.agent.firmware.FirmwareCommand.ArmMeasures;
import org.toqa.agent.firmware.FirmwareCommand.Caption;
import org.toqa.agent.firmware.FirmwareCommand.Clear;
import org.toqa.agent.firmware.FirmwareCommand.Poll;
import org.toqa.agent.firmware.FirmwareCommand.Settings;
import org.toqa.agent.firmware.FirmwareCommand.Velocity;
import org.toqa.agent.firmware.FirmwareStatus.Answer;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.motion.Odometry;
import org.toqa.motion.ThreeWheelKinematics;
import org.toqa.motion.WheelSpeeds;

/**
 * The real body: a microcontroller that is sent a velocity or the segments of a path at every tick,
 * and seldom while it is stopped, which spares the processor of the robot. A stop that may be
 * cleared without a person, by power-up or by a link that was silent, is cleared here.
 */
public final class FirmwareChassis implements Chassis {

  private static final Logger log = LoggerFactory.getLogger(FirmwareChassis.class);

  private static final double RADIANS_A_COUNT = 2 * Math.PI / Odometry.COUNTS_PER_WHEEL_TURN;

  /** Exchanges until a microcontroller that was just switched on answers. */
  private static final int FIRST_EXCHANGES = 100;

  /** Exchanges without an answer, 200 ms, until the daemon says so. */
  private static final int SILENT_EXCHANGES = 10;

  /** Exchanges in which a clear is sent at most, 0.5 s: so long a person's word is good. */
  private static final int CLEAR_SENDS = 25;

  private static final FirmwareCommand STANDSTILL = new Velocity(Twist.ZERO);

  /** A body that is stopped is sent commands no oftener; its time limit for one is 200 ms. */
  private static final long STANDSTILL_INTERVAL_NANOS = 60_000_000;

  /** Failures are logged no oftener. */
  private static final long LOG_INTERVAL_NANOS = 60_000_000_000L;

  private static final Fault POOR_LINK =
      new Fault(
          "CHASSIS_LINK",
          "Of the exchanges with the robot's microcontroller one in five fails: check its cable.");

  private static final Fault SILENT =
      new Fault("CHASSIS_SILENT", "The robot's microcontroller does not answer.");

  private static final Fault NO_SETTINGS =
      new Fault(
          "CHASSIS_SETTINGS",
          "The robot's microcontroller does not take the measures of its wheels or its arm: its"
              + " firmware is another version than the daemon.");

  private static final Fault BLIND =
      new Fault(
          "RANGE_SENSORS",
          "The robot sees nothing: its range sensors are silent or wrong. Check their board and"
              + " cable.");

  private final FrameTransport transport;
  private final String caption;
  private final @Nullable Pose start;
  private final boolean hasRangeSensors;
  private final BatteryGauge battery = new BatteryGauge();
  private final ThreeWheelKinematics wheels;
  private final @Nullable FirmwareArm arm;
  private final SettingsSender settings;
  private final PathSender paths = new PathSender();
  private FirmwareStatus status;
  private Twist twist = Twist.ZERO;
  private FirmwareCommand lastCommand = STANDSTILL;
  private int sequence;
  private int unanswered;
  private final LinkQuality quality = new LinkQuality();
  private long loggedFailures;
  private long loggedNanos;
  private long exchangedNanos;
  private boolean isCaptionSent;

  /** Codes of faults, until the next exchange. */
  private Set<String> clearRequested = Set.of();

  /** What a person cleared, until the microcontroller has answered that. */
  private @Nullable PendingClear pendingClear;

  /**
   * A clear that was sent. It is sent again under its own number, which the microcontroller obeys
   * once, and nothing else is sent before it is answered: so it clears nothing that came later.
   *
   * @param sequence of its frame
   * @param powerCycle of the microcontroller that stopped the robot
   * @param sends how often it was sent
   */
  private record PendingClear(Clear clear, int sequence, int powerCycle, int sends) {}

  /**
   * Finds the microcontroller.
   *
   * @param caption what the display shows first
   * @param start where the body was when it was switched on for the first time, map frame, if
   *     somebody has put it there
   * @param hasRangeSensors whether it must see to drive; false: what it says of ranges is ignored
   * @param settings of this robot
   * @param armSettings of its arm; null: it has none
   * @param nanos now, nanoseconds on the daemon's monotonic clock
   * @throws IOException if no microcontroller answers
   */
  public FirmwareChassis(
      FrameTransport transport,
      String caption,
      @Nullable Pose start,
      boolean hasRangeSensors,
      FirmwareSettings settings,
      @Nullable ArmSettings armSettings,
      long nanos)
      throws IOException {
    this.transport = transport;
    this.wheels = settings.wheels();
    this.arm = armSettings == null ? null : new FirmwareArm(armSettings, transport);
    this.settings =
        new SettingsSender(
            armSettings == null
                ? List.of(new Settings(settings))
                : List.of(new Settings(settings), new ArmMeasures(armSettings)));
    this.caption = caption;
    this.start = start;
    this.hasRangeSensors = hasRangeSensors;
    status = awaitFirstStatus(nanos);
    battery.update(status.batteryVolts(), 0);
    sequence = status.sequence();
    if (arm != null) {
      awaitArm(arm, nanos);
    }
  }

  /** Its measures are sent, and its sensors read. */
  private void awaitArm(FirmwareArm mounted, long nanos) throws IOException {
    for (int i = 0; i < FIRST_EXCHANGES && !mounted.isKnown(); i++) {
      exchange(MoveAt.STANDSTILL, nanos);
    }
    if (!mounted.isKnown()) {
      throw new IOException(
          "The robot's microcontroller tells nothing of its arm: check that its firmware is as new"
              + " as the daemon, or remove \"arm\".");
    }
  }

  private FirmwareStatus awaitFirstStatus(long nanos) throws IOException {
    for (int i = 0; i < FIRST_EXCHANGES; i++) {
      byte[] answer = transport.exchange(FrameCodec.encode(new Poll(), 0), nanos);
      Optional<FirmwareStatus> first = FrameCodec.decode(answer);
      if (first.isPresent()) {
        return first.get();
      }
    }
    throw new IOException("The robot's microcontroller does not answer.");
  }

  @Override
  public ChassisReading exchange(ChassisCommand wanted, long nanos) {
    FirmwareCommand command = nextCommand(wanted, nanos);
    if (isAtRest(command) && nanos - exchangedNanos < STANDSTILL_INTERVAL_NANOS) {
      return reading();
    }
    exchangedNanos = nanos;
    lastCommand = command;
    numberNext(command);
    if (arm != null) {
      arm.recordSent(command);
    }
    try {
      take(transport.exchange(FrameCodec.encode(command, sequence), nanos));
    } catch (IOException e) {
      if (unanswered++ == 0) {
        log.warn("The robot's microcontroller cannot be reached: {}", e.getMessage());
      }
    }
    quality.recordExchange(unanswered == 0);
    logFailures(nanos);
    return reading();
  }

  private void take(byte[] answer) {
    Optional<FirmwareStatus> ofWheels = FrameCodec.decode(answer);
    Optional<ArmStatus> ofArm = FrameCodec.decodeArm(answer);
    if (ofWheels.isPresent()) {
      update(ofWheels.get());
    } else if (arm != null && ofArm.isPresent()) {
      unanswered = 0;
      arm.update(ofArm.get());
    } else {
      unanswered++;
    }
  }

  @Override
  public Optional<ArmDrive> arm() {
    return Optional.ofNullable(arm);
  }

  /** A clear that is sent again keeps its number. */
  private void numberNext(FirmwareCommand command) {
    PendingClear pending = pendingClear;
    if (pending != null) {
      pendingClear =
          new PendingClear(
              pending.clear(), pending.sequence(), pending.powerCycle(), pending.sends() + 1);
      sequence = pending.sequence();
      return;
    }
    int next = (sequence + 1) % FrameCodec.SEQUENCES;
    sequence = settings.isOfThem(command) ? settings.sequence(next) : next;
    if (command instanceof Clear clear && clear.byPerson()) {
      pendingClear = new PendingClear(clear, sequence, status.powerCycle(), 1);
    }
  }

  private void logFailures(long nanos) {
    if (quality.totalFailures() > loggedFailures && nanos - loggedNanos >= LOG_INTERVAL_NANOS) {
      log.warn(
          "{} of {} exchanges with the robot's microcontroller have failed; it counts {} bad"
              + " frames and {} lost bytes.",
          quality.totalFailures(),
          quality.exchanges(),
          status.badFrames(),
          status.lostBytes());
      loggedFailures = quality.totalFailures();
      loggedNanos = nanos;
    }
  }

  private boolean isAtRest(FirmwareCommand command) {
    return isStandstill(command)
        && isStandstill(lastCommand)
        && (arm == null || !arm.isBusy())
        && unanswered == 0
        && settings.isTaken(status)
        && reading().isStanding();
  }

  /** Also what is said of an arm that does nothing. */
  private static boolean isStandstill(FirmwareCommand command) {
    return command.equals(STANDSTILL) || command.isOfArm();
  }

  @Override
  public void clearStops(Set<String> reasons) {
    clearRequested = Set.copyOf(reasons);
  }

  @Override
  public void close() {
    transport.close();
  }

  private FirmwareCommand nextCommand(ChassisCommand wanted, long nanos) {
    PendingClear pending = pendingClear;
    if (pending != null && pending.sends() < CLEAR_SENDS) {
      return pending.clear();
    }
    if (pending != null) {
      log.warn("The robot's microcontroller did not answer a clear; it was given up.");
      pendingClear = null;
    }
    Set<String> cleared = clearRequested;
    clearRequested = Set.of();
    Set<StopReason> byPerson =
        stops(reason -> reason.fault().clearable() && cleared.contains(reason.fault().code()));
    if (!byPerson.isEmpty()) {
      return new Clear(byPerson, true);
    }
    Set<StopReason> own = stops(StopReason::isClearedByDaemon);
    if (!own.isEmpty()) {
      return new Clear(own, false);
    }
    Optional<FirmwareCommand> first = settings.next(status);
    if (first.isPresent()) {
      return first.get();
    }
    if (!isCaptionSent) {
      isCaptionSent = true;
      return new Caption(caption);
    }
    if (arm != null) {
      Optional<FirmwareCommand> ofArm = arm.next(status.isMoving(), nanos);
      if (ofArm.isPresent()) {
        return ofArm.get();
      }
    }
    return switch (wanted) {
      case MoveAt(Twist velocity) -> new Velocity(velocity);
      case DrivePath path -> paths.next(path, status);
    };
  }

  private Set<StopReason> stops(Predicate<StopReason> wanted) {
    return status.stopReasons().stream().filter(wanted).collect(Collectors.toSet());
  }

  private void update(FirmwareStatus now) {
    unanswered = 0;
    if (now.powerCycle() != status.powerCycle()) {
      battery.reset();
      isCaptionSent = false;
      twist = Twist.ZERO;
    } else {
      twist = twistBetween(status, now).orElse(twist);
    }
    battery.update(now.batteryVolts(), (now.stampMillis() - status.stampMillis()) / 1e3);
    if (now.answer() == Answer.OUT_OF_RANGE || now.answer() == Answer.UNKNOWN_KIND) {
      log.warn("The robot's microcontroller refused a command: {}", now.answer());
    }
    status = now;
    settings.update(now);
    PendingClear pending = pendingClear;
    if (pending != null
        && (now.sequence() == pending.sequence() || now.powerCycle() != pending.powerCycle())) {
      pendingClear = null;
    }
  }

  private Optional<Twist> twistBetween(FirmwareStatus before, FirmwareStatus now) {
    double seconds = (now.stampMillis() - before.stampMillis()) / 1e3;
    if (seconds <= 0) {
      return Optional.empty();
    }
    return Optional.of(
        wheels.twist(
            WheelSpeeds.of(
                wheels.wheelCount(),
                wheel -> {
                  // as counters wrap around
                  int moved = now.counts().get(wheel) - before.counts().get(wheel);
                  return moved * RADIANS_A_COUNT / seconds;
                })));
  }

  private ChassisReading reading() {
    return new ChassisReading(
        status.powerCycle(),
        status.powerCycle() == 1 ? start : null,
        status.odometry(),
        unanswered == 0 ? twist : Twist.ZERO,
        status.stopReasons().contains(StopReason.BATTERY) ? 0 : battery.charge(), // it says so
        hasRangeSensors ? status.ranges() : List.of(),
        faults(),
        null, // it has no scale
        paths.progress(status));
  }

  private List<Fault> faults() {
    List<Fault> faults = new ArrayList<>();
    if (unanswered >= SILENT_EXCHANGES) {
      faults.add(SILENT);
    } else if (quality.isPoor()) {
      faults.add(POOR_LINK);
    }
    if (settings.isRefused()) {
      faults.add(NO_SETTINGS);
    }
    if (hasRangeSensors && status.ranges().isEmpty()) {
      faults.add(BLIND);
    }
    status.stopReasons().stream().sorted().map(this::fault).forEach(faults::add);
    return faults;
  }

  private Fault fault(StopReason reason) {
    Fault fault = reason.fault();
    return reason == StopReason.HEAT
        ? new Fault(
            fault.code(),
            "%s It has %d degrees Celsius.".formatted(fault.text(), status.temperature()),
            fault.clearable())
        : fault;
  }
}
