package org.toqa.agent.firmware;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import java.util.Random;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.toqa.agent.chassis.ChassisReading;
import org.toqa.geometry.Twist;
import org.toqa.testbed.FuzzRun;
import org.toqa.testbed.LogLevel;

/**
 * Whatever a microcontroller, or a bad wire, sends: the daemon gets numbers that it can use, and
 * what is no good frame changes nothing.
 */
class FrameFuzzTest {

  private static final long TICK = 20_000_000;

  /** A body that is stopped is not sent a frame at every tick. */
  private static final Twist SLOWLY = new Twist(0.1, 0, 0);

  /** An answer of so many bytes means a wire that is cut. */
  private static final int CUT = 1;

  private final Random random = new Random(FuzzRun.SEED);
  private byte[] answer = new byte[0];
  private boolean isObedient;
  private long nanos;

  @Test
  void noFrameHarmsTheChassis() throws IOException {
    List<byte[]> correct = GoldenFrame.of("status");
    answer = correct.getFirst();
    long begin = System.nanoTime();
    long good = 0;
    try (LogLevel _ = LogLevel.errors("org.toqa.agent");
        FirmwareChassis chassis =
            new FirmwareChassis(
                answering(), "r1", null, true, FirmwareSettings.DEFAULT, null, nanos)) {
      ChassisReading before = chassis.exchange(SLOWLY, nanos);
      for (long input = 0; input < FuzzRun.INPUTS; input++) {
        answer = fuzzed(correct.get(random.nextInt(correct.size())).clone());
        String what = "input %d of seed %d".formatted(input, FuzzRun.SEED);
        boolean isGood = FrameCodec.decode(answer).isPresent();
        ChassisReading reading = chassis.exchange(SLOWLY, nanos += TICK);
        assertUsable(reading, what);
        if (!isGood) {
          assertEquals(before.odometry(), reading.odometry(), what);
          assertEquals(before.battery(), reading.battery(), what);
          assertEquals(Twist.ZERO, reading.twist(), what);
        }
        good += isGood ? 1 : 0;
        before = reading;
      }

      answer = correct.get(1);
      isObedient = true;
      for (int i = 0; i < 250; i++) {
        chassis.exchange(SLOWLY, nanos += TICK); // until the link counts as good again
      }
      assertEquals(List.of(), chassis.exchange(SLOWLY, nanos += TICK).faults());
    }
    assertTrue(good > FuzzRun.INPUTS / 4, good + " good frames");
    assertTrue(good < 3 * FuzzRun.INPUTS / 4, good + " good frames");
    FuzzRun.tell(
        "the frames of the microcontroller",
        FuzzRun.INPUTS,
        "%,d were good statuses".formatted(good),
        begin);
  }

  @Test
  void everyWholeFrameIsFoundInAnyStream() {
    FrameScanner scanner = new FrameScanner();
    byte[] frame = FrameCodec.encode(new FirmwareCommand.Poll(), 7);
    long begin = System.nanoTime();
    long sent = 0;
    long found = 0;
    for (long input = 0; input < FuzzRun.INPUTS; input++) {
      byte[] piece = random.nextInt(3) == 0 ? frame : noise(random.nextInt(100));
      sent += piece == frame ? 1 : 0;
      scanner.add(piece, piece.length);
      while (scanner.takeFrame().isPresent()) {
        found++;
      }
    }

    assertEquals(sent, found);
    assertTrue(found > FuzzRun.INPUTS / 4, found + " whole frames");
    FuzzRun.tell("a serial stream", FuzzRun.INPUTS, "%,d frames found".formatted(found), begin);
  }

  private FrameTransport answering() {
    return new FrameTransport() {
      @Override
      public byte[] exchange(byte[] frame, long at) throws IOException {
        if (answer.length == CUT) {
          throw new IOException("The wire is cut.");
        }
        return isObedient ? GoldenFrame.answer(answer, frame) : answer;
      }

      @Override
      public void close() {}
    };
  }

  /** With other content and a right check sum, with other bits, or of another length. */
  private byte[] fuzzed(byte[] frame) {
    switch (random.nextInt(4)) {
      case 0 -> {
        for (int i = random.nextInt(8); i >= 0; i--) {
          frame[4 + random.nextInt(58)] = (byte) random.nextInt();
        }
        int crc = Crc16.of(frame, 62);
        ByteBuffer.wrap(frame).order(ByteOrder.LITTLE_ENDIAN).putShort(62, (short) crc);
        return frame;
      }
      case 1 -> {
        for (int i = random.nextInt(8); i >= 0; i--) {
          frame[random.nextInt(frame.length)] ^= (byte) (1 << random.nextInt(8));
        }
        return frame;
      }
      case 2 -> {
        return noise(random.nextInt(2 * FrameCodec.LENGTH));
      }
      default -> {
        return frame;
      }
    }
  }

  private byte[] noise(int length) {
    byte[] bytes = new byte[length];
    random.nextBytes(bytes);
    return bytes;
  }

  private static void assertUsable(ChassisReading reading, String what) {
    assertTrue(
        DoubleStream.concat(
                DoubleStream.of(
                    reading.odometry().x(),
                    reading.odometry().y(),
                    reading.odometry().theta(),
                    reading.twist().vx(),
                    reading.twist().vy(),
                    reading.twist().w()),
                Stream.of(reading.ranges()).flatMap(List::stream).mapToDouble(Double::doubleValue))
            .allMatch(Double::isFinite),
        what);
    assertTrue(reading.battery() >= 0 && reading.battery() <= 1, what);
    assertTrue(reading.faults().stream().noneMatch(fault -> fault.text().isBlank()), what);
  }
}
