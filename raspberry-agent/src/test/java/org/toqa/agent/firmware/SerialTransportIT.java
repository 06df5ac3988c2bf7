package org.toqa.agent.firmware;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.Timeout.ThreadMode;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.agent.chassis.Chassis;
import org.toqa.agent.chassis.ChassisReading;
import org.toqa.agent.firmware.FirmwareCommand.Velocity;
import org.toqa.geometry.Twist;
import org.toqa.link.message.AgentMessage.Fault;

/** Golden frames over a real serial port of the kernel's. */
@Tag("full")
@Timeout(value = 60, threadMode = ThreadMode.SEPARATE_THREAD)
class SerialTransportIT {

  private static final int BAUD = 115_200;
  private static final long TICK = 20_000_000;
  private static final int MOST_EXCHANGES = 500;
  private static final Twist AHEAD = new Twist(0.25, 0, 0);

  @TempDir Path folder;
  private Path device;
  private byte[] command;
  private byte[] status;
  private long nanos;

  /** How often a machine that is busy with other things had to ask for an answer. */
  private int asked;

  @BeforeEach
  void readGoldenFrames() throws IOException {
    device = folder.resolve("robot");
    command = GoldenFrame.of("velocity").getFirst();
    status = GoldenFrame.of("status").get(1);
  }

  @Test
  void commandGoesOutAndStatusComesIn() throws Exception {
    try (SerialCable cable = SerialCable.plugIn(device, frame -> status);
        FrameTransport transport = new SerialTransport(device, BAUD)) {
      for (byte[] golden : GoldenFrame.of("velocity")) {
        int before = asked;
        assertArrayEquals(status, answerTo(golden, transport));
        for (int i = before; i < asked; i++) {
          assertArrayEquals(golden, cable.heard());
        }
      }
    }
  }

  @Test
  void answerIsFoundAmongOtherBytes() throws Exception {
    byte[] noise = {0x00, (byte) 0xA5, 0x5A, 0x7F, (byte) 0xA5};
    try (SerialCable _ = SerialCable.plugIn(device, frame -> join(noise, half(), status));
        FrameTransport transport = new SerialTransport(device, BAUD)) {
      assertArrayEquals(status, answerTo(command, transport));
    }
  }

  @Test
  void halfAnAnswerIsNoneAndHarmsNoLaterOne() throws Exception {
    Deque<byte[]> first = new ArrayDeque<>(List.of(half(), new byte[0]));
    byte[] later = join(half(), status);
    try (SerialCable _ =
            SerialCable.plugIn(device, frame -> first.isEmpty() ? later : first.removeFirst());
        FrameTransport transport = new SerialTransport(device, BAUD)) {
      assertEquals(0, transport.exchange(command, nanos).length);
      assertEquals(0, transport.exchange(command, nanos).length);
      assertArrayEquals(status, answerTo(command, transport));
    }
  }

  /** A machine that is busy with other things holds most exchanges up, but not all. */
  @Test
  void silenceCostsLessThanATick() throws Exception {
    try (SerialCable _ = SerialCable.plugIn(device, frame -> new byte[0]);
        FrameTransport transport = new SerialTransport(device, BAUD)) {
      long fastest = Long.MAX_VALUE;
      for (int i = 0; i < MOST_EXCHANGES && fastest >= TICK; i++) {
        long begin = System.nanoTime();
        assertEquals(0, transport.exchange(command, nanos).length);
        fastest = Math.min(fastest, System.nanoTime() - begin);
      }

      // both frames on the wire: 2 * 64 * 10 bits at 115,200 bits/s = 11.1 ms
      assertTrue(fastest > 11_100_000 && fastest < TICK, fastest + " ns");
    }
  }

  @Test
  void pulledCableIsAFaultUntilItIsPluggedInAgain() throws Exception {
    Chassis chassis;
    try (SerialCable _ = SerialCable.plugIn(device, frame -> GoldenFrame.answer(status, frame))) {
      chassis =
          new FirmwareChassis(
              new SerialTransport(device, BAUD),
              "r1",
              null,
              true,
              FirmwareSettings.DEFAULT,
              null,
              nanos);
      assertEquals(List.of(), codes(live(chassis, 2)));
    }
    try (chassis) {
      assertEquals(List.of("CHASSIS_SILENT"), codes(live(chassis, 10)));
      try (SerialCable cable =
          SerialCable.plugIn(device, frame -> GoldenFrame.answer(status, frame))) {
        ChassisReading reading = live(chassis, 50); // a second: it looks for the port twice
        for (int i = 0; i < MOST_EXCHANGES && !codes(reading).isEmpty(); i++) {
          reading = live(chassis, 1);
        }
        assertEquals(List.of(), codes(reading));
        byte[] heard = cable.heard();
        assertArrayEquals(FrameCodec.encode(new Velocity(AHEAD), heard[3]), heard);
      }
    }
  }

  @Test
  void missingPortIsNamed() {
    IOException missing =
        assertThrows(IOException.class, () -> new SerialTransport(device, BAUD).close());

    assertEquals("There is no serial port " + device + ".", missing.getMessage());
  }

  /** A busy machine holds some exchanges up for longer than an answer is waited for. */
  private byte[] answerTo(byte[] frame, FrameTransport transport) throws IOException {
    byte[] answer = new byte[0];
    for (int i = 0; i < MOST_EXCHANGES && answer.length == 0; i++) {
      answer = transport.exchange(frame, nanos);
      asked++;
    }
    return answer;
  }

  private ChassisReading live(Chassis chassis, int ticks) {
    ChassisReading last = chassis.exchange(AHEAD, nanos += TICK);
    for (int i = 1; i < ticks; i++) {
      last = chassis.exchange(AHEAD, nanos += TICK);
    }
    return last;
  }

  private byte[] half() {
    return Arrays.copyOf(status, FrameCodec.LENGTH / 2);
  }

  private static byte[] join(byte[]... parts) {
    int length = Arrays.stream(parts).mapToInt(part -> part.length).sum();
    byte[] all = new byte[length];
    int end = 0;
    for (byte[] part : parts) {
      System.arraycopy(part, 0, all, end, part.length);
      end += part.length;
    }
    return all;
  }

  private static List<String> codes(ChassisReading reading) {
    return reading.faults().stream().map(Fault::code).toList();
  }
}
