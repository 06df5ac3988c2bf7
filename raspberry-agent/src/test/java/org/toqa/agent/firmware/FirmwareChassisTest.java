package org.toqa.agent.firmware;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.toqa.agent.firmware.FirmwareCommand.Velocity;
import org.toqa.geometry.Twist;
import org.toqa.link.message.AgentMessage.Fault;

/** Over a microcontroller that always reports that it is stopped. */
class FirmwareChassisTest {
  private static final int TICK = 20_000_000;
  private static final int SEQUENCE = 7;
  private static final int SECOND = 50;
  private static final Twist FORWARD = new Twist(0.25, 0, 0);

  private final List<byte[]> sent = new ArrayList<>();
  private byte[] answer = new byte[0];
  private FirmwareChassis chassis;
  private long nanos;

  @BeforeEach
  void findMicrocontroller() throws IOException {
    answer = GoldenFrame.of("status").get(1);
    chassis =
        new FirmwareChassis(
            new FrameTransport() {
              @Override
              public byte[] exchange(byte[] frame, long now) {
                sent.add(frame);
                return answer;
              }

              @Override
              public void close() {
                sent.clear();
              }
            },
            "r1",
            null,
            0);
    tick(Twist.ZERO, 10);
    sent.clear();
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
