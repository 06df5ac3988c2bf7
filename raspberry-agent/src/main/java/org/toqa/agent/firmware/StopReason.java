package org.toqa.agent.firmware;

import java.util.EnumSet;
import java.util.Set;
import org.toqa.link.message.AgentMessage.Fault;

/**
 * Why the microcontroller has stopped the motors; in the order of the bits of {@code
 * docs/spi-frame.md}.
 */
public enum StopReason {
  POWER_UP("The robot was switched on and has not been told to drive."),
  LINK("The microcontroller heard nothing from the daemon for 200 ms."),
  SWITCH("Somebody pressed the stop switch on the robot."),
  EDGE("A floor sensor sees no floor."),
  HEAT("The motor driver is too hot."),
  BATTERY("The battery is empty: charge it."),
  STALL("A wheel does not turn as it is told: something blocks it."),
  DRIVE("A motor controller does not answer or reports an error."),
  WATCHDOG("The microcontroller's program hung and was started anew.");

  private final String sentence;

  StopReason(String sentence) {
    this.sentence = sentence;
  }

  /** Whether the daemon may clear it by itself; else only a person may. */
  boolean isClearedByDaemon() {
    return this == POWER_UP || this == LINK;
  }

  Fault fault() {
    return new Fault("STOP_" + name(), sentence, !isClearedByDaemon());
  }

  static Set<StopReason> ofBits(int bits) {
    Set<StopReason> reasons = EnumSet.noneOf(StopReason.class);
    for (StopReason reason : values()) {
      if ((bits >> reason.ordinal() & 1) != 0) {
        reasons.add(reason);
      }
    }
    return reasons;
  }

  static int bits(Set<StopReason> reasons) {
    return reasons.stream().mapToInt(reason -> 1 << reason.ordinal()).sum();
  }
}
