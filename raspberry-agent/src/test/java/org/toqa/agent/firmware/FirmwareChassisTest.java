package org.toqa.agent.firmware;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.agent.chassis.ChassisReading;
import org.toqa.agent.firmware.FirmwareCommand.Clear;
import org.toqa.agent.firmware.FirmwareCommand.Velocity;
import org.toqa.geometry.Twist;
import org.toqa.link.message.AgentMessage.Fault;

/** Over a microcontroller that always reports that it is stopped. */
class FirmwareChassisTest {
  private static final int TICK = 20_000_000;
  private static final int SEQUENCE = 7;
  private static final int SETTINGS = 6;
  private static final int SECOND = 50;
  private static final Twist FORWARD = new Twist(0.25, 0, 0);

  private final List<byte[]> sent = new ArrayList<>();
  private byte[] answer = new byte[0];
  private FirmwareChassis chassis;
  private long nanos;

  @BeforeEach
  void findMicrocontroller() throws IOException {
    answer = sealed(GoldenFrame.of("status").get(1), 5, (byte) 1); // at rest
    chassis = new FirmwareChassis(transport(), "r1", null, true, FirmwareSettings.DEFAULT, null, 0);
    tick(Twist.ZERO, 11);
    sent.clear();
  }

  private FrameTransport transport() {
    return new FrameTransport() {
      @Override
      public byte[] exchange(byte[] frame, long now) {
        if (frame[2] == SETTINGS && answer.length > 0) {
          answer = sealed(answer, 3, frame[3]); // it has them
        }
        sent.add(frame);
        return answer;
      }

      @Override
      public void close() {
        sent.clear();
      }
    };
  }

  @AfterEach
  void close() {
    chassis.close();
  }

  @Test
  void bodyAtRestIsSpokenToLessThanEveryTickAndOftenerThanItEndures() {
    tick(Twist.ZERO, 99);
    assertEquals(33, sent.size());
  }

  @Test
  void velocityIsSentInItsTickAndTheStopToo() {
    tick(FORWARD, 1);
    assertVelocity(FORWARD);
    tick(FORWARD, 9);
    assertEquals(10, sent.size());
    tick(Twist.ZERO, 1);
    assertVelocity(Twist.ZERO);
  }

  @Test
  void linkOnWhichEveryFourthFrameIsLostStopsTheRobotUntilItIsBetter() {
    byte[] good = answer;
    for (int i = 0; i < 5 * SECOND; i++) {
      answer = i % 4 == 0 ? new byte[0] : good;
      tick(FORWARD, 1);
    }
    assertEquals(List.of("CHASSIS_LINK"), codes());
    answer = good;
    tick(FORWARD, 5 * SECOND);
    assertEquals(List.of(), codes());
  }

  @Test
  void fewLostFramesAreBorne() {
    byte[] good = answer;
    for (int i = 0; i < 60 * SECOND; i++) {
      answer = i % 10 == 0 ? new byte[0] : good;
      tick(FORWARD, 1);
      assertEquals(List.of(), codes());
    }
  }

  private List<String> codes() {
    return chassis.exchange(FORWARD, nanos).faults().stream().map(Fault::code).toList();
  }

  /** 65,535: the sensor is silent; 900 is farther than any sees. */
  @ParameterizedTest
  @ValueSource(ints = {65_535, 900})
  void oneRangeSensorThatTellsNoDistanceIsAFault(int millimetres) {
    byte[] good = answer;
    answer = withRange(1, millimetres);
    tick(FORWARD, 1);
    ChassisReading blind = chassis.exchange(FORWARD, nanos);
    assertEquals(List.of(), blind.ranges());
    assertEquals(List.of("RANGE_SENSORS"), codes());
    assertEquals(Set.of(), blind.stops());

    answer = good;
    tick(FORWARD, 1);
    assertEquals(List.of(), codes());
  }

  @Test
  void bodyWithoutRangeSensorsDrivesWithoutThem() throws IOException {
    answer = withRange(2, 65_535);
    try (FirmwareChassis without =
        new FirmwareChassis(transport(), "r1", null, false, FirmwareSettings.DEFAULT, null, 0)) {
      ChassisReading reading = without.exchange(FORWARD, TICK);
      assertEquals(List.of(), reading.ranges());
      assertEquals(List.of(), reading.faults());
    }
  }

  /** Rims at sqrt(3)/2 of 0.25 m/s: 5.413 rad/s, of 2808 counts a turn 242 in 0.1 s. */
  @ParameterizedTest
  @CsvSource({
    "242, 0, -242, 0.25, 0, 0",
    "-242, 0, 242, -0.25, 0, 0",
    "-56, 112, -56, 0, 0.1, 0", // rims at 1/2, 1 and 1/2 of 0.1 m/s
    "112, 112, 112, 0, 0, 1", // all rims at 0.1 m/s, 0.1 m from the middle
  })
  void whatTheWheelsHaveTurnedIsHowItMoves(
      int first, int second, int third, double vx, double vy, double w) {
    int[] counts = {0, Integer.MAX_VALUE, Integer.MIN_VALUE}; // two counters wrap around
    answer = withWheels(1_000, counts);
    tick(FORWARD, 1);
    answer = withWheels(1_100, counts[0] + first, counts[1] + second, counts[2] + third);
    Twist twist = chassis.exchange(FORWARD, nanos += TICK).twist();

    assertEquals(vx, twist.vx(), 0.002);
    assertEquals(vy, twist.vy(), 0.002);
    assertEquals(w, twist.w(), 0.01);
  }

  private byte[] withWheels(int stampMillis, int... counts) {
    byte[] changed = answer.clone();
    ByteBuffer frame = ByteBuffer.wrap(changed).order(ByteOrder.LITTLE_ENDIAN);
    frame.putInt(10, stampMillis);
    for (int wheel = 0; wheel < counts.length; wheel++) {
      frame.putInt(14 + 4 * wheel, counts[wheel]);
    }
    frame.putShort(62, (short) Crc16.of(changed, 62));
    return changed;
  }

  private byte[] withRange(int sensor, int millimetres) {
    byte[] changed = answer.clone();
    ByteBuffer frame = ByteBuffer.wrap(changed).order(ByteOrder.LITTLE_ENDIAN);
    frame.putShort(38 + 2 * sensor, (short) millimetres);
    frame.putShort(62, (short) Crc16.of(changed, 62));
    return changed;
  }

  /** Power-up is the daemon's to clear, in the exchange after. */
  @Test
  void aPersonClearsWhatHeNamedAndNothingElse() throws IOException {
    answer = GoldenFrame.of("status").getLast(); // stopped for every reason
    tick(Twist.ZERO, 1);
    chassis.clearStops(Set.of("STOP_EDGE", "STOP_POWER_UP"));
    sent.clear();
    tick(Twist.ZERO, 1);
    answerLast();
    tick(Twist.ZERO, 2);

    assertSent(new Clear(Set.of(StopReason.EDGE), true), sent.getFirst());
    assertSent(new Clear(Set.of(StopReason.POWER_UP, StopReason.LINK), false), sent.getLast());
  }

  /** Nothing else is sent meanwhile: as an older number it would be obeyed once more. */
  @Test
  void aClearIsSentUnderItsNumberUntilItIsAnswered() throws IOException {
    answer = GoldenFrame.of("status").getLast();
    tick(Twist.ZERO, 1);
    chassis.clearStops(Set.of("STOP_EDGE"));
    sent.clear();
    tick(Twist.ZERO, 5);

    assertSent(new Clear(Set.of(StopReason.EDGE), true), sent.getFirst());
    sent.forEach(frame -> assertArrayEquals(sent.getFirst(), frame));
    answerLast();
    tick(Twist.ZERO, 1);
    sent.clear();
    tick(Twist.ZERO, 1);
    assertSent(new Clear(Set.of(StopReason.POWER_UP, StopReason.LINK), false), sent.getLast());
  }

  @Test
  void aClearThatIsNeverAnsweredIsGivenUp() throws IOException {
    answer = GoldenFrame.of("status").getLast();
    tick(Twist.ZERO, 1);
    chassis.clearStops(Set.of("STOP_EDGE"));
    sent.clear();
    tick(Twist.ZERO, 2 * SECOND);

    assertEquals(SECOND / 2, sent.stream().filter(f -> Arrays.equals(f, sent.getFirst())).count());
  }

  @Test
  void aClearIsForTheMicrocontrollerThatStoppedOnly() throws IOException {
    answer = GoldenFrame.of("status").getLast();
    tick(Twist.ZERO, 1);
    chassis.clearStops(Set.of("STOP_EDGE"));
    tick(Twist.ZERO, 1);
    answer = sealed(GoldenFrame.of("status").getLast(), 8, (byte) 99); // it was switched off and on
    tick(Twist.ZERO, 1);
    sent.clear();
    tick(Twist.ZERO, 5);

    assertTrue(
        sent.stream()
            .noneMatch(
                f ->
                    Arrays.equals(
                        f,
                        FrameCodec.encode(new Clear(Set.of(StopReason.EDGE), true), f[3] & 0xff))));
  }

  /** The microcontroller has received the last frame. */
  private void answerLast() {
    answer = sealed(answer, 3, sent.getLast()[3]);
  }

  private static byte[] sealed(byte[] frame, int index, byte value) {
    byte[] changed = frame.clone();
    changed[index] = value;
    ByteBuffer.wrap(changed)
        .order(ByteOrder.LITTLE_ENDIAN)
        .putShort(62, (short) Crc16.of(changed, 62));
    return changed;
  }

  private static void assertSent(FirmwareCommand command, byte[] frame) {
    assertArrayEquals(FrameCodec.encode(command, frame[3] & 0xff), frame);
  }

  @Test
  void microcontrollerThatFallsSilentAtRestIsNoticedIn300Milliseconds() {
    answer = new byte[0];
    tick(Twist.ZERO, 14);
    assertTrue(
        chassis.exchange(Twist.ZERO, nanos).faults().stream()
            .anyMatch(fault -> fault.code().equals("CHASSIS_SILENT")));
  }

  private void tick(Twist wanted, int times) {
    for (int i = 0; i < times; i++) {
      nanos += TICK;
      chassis.exchange(wanted, nanos);
    }
  }

  private void assertVelocity(Twist twist) {
    int sequence = sent.getLast()[3] & 0xff;
    assertTrue(sequence > SEQUENCE);
    assertArrayEquals(FrameCodec.encode(new Velocity(twist), sequence), sent.getLast());
  }
}
