package org.toqa.agent.firmware;

import java.util.List;
import java.util.Optional;
import org.toqa.agent.firmware.FirmwareCommand.Velocity;
import org.toqa.agent.firmware.FirmwareStatus.Answer;
import org.toqa.geometry.Twist;

/**
 * Brings the settings of robot and arm to the microcontroller, again after each of its starts.
 * Nothing else is driven before it has answered that it has them: by other wheels it would drive
 * elsewhere.
 */
final class SettingsSender {

  /** A second; by then a microcontroller that takes them has said so. */
  private static final int MOST_SENDS = 50;

  private final List<FirmwareCommand> settings;
  private int taken;
  private int askedCycle = -1;
  private int sentSequence = -1;
  private int sends;

  /**
   * @param settings in the order in which they are sent
   */
  SettingsSender(List<FirmwareCommand> settings) {
    this.settings = List.copyOf(settings);
  }

  boolean isTaken(FirmwareStatus status) {
    return status.powerCycle() == askedCycle && taken == settings.size();
  }

  /** What must be sent first; empty once the microcontroller has the settings. */
  Optional<FirmwareCommand> next(FirmwareStatus status) {
    if (isTaken(status)) {
      return Optional.empty();
    }
    if (status.powerCycle() != askedCycle) {
      askedCycle = status.powerCycle();
      taken = 0;
      sentSequence = -1;
      sends = 0;
    }
    return Optional.of(status.isMoving() ? new Velocity(Twist.ZERO) : settings.get(taken));
  }

  /** Whether this is of them. */
  boolean isOfThem(FirmwareCommand command) {
    return settings.contains(command);
  }

  /**
   * Under which sequence the settings are sent now: until they are answered under the same one.
   *
   * @param next that of a new command
   */
  int sequence(int next) {
    sends++;
    if (sentSequence < 0) {
      sentSequence = next;
    }
    return sentSequence;
  }

  void update(FirmwareStatus status) {
    if (status.sequence() != sentSequence) {
      return;
    }
    sentSequence = -1;
    if (status.answer() == Answer.DONE) {
      taken++;
      sends = 0;
    }
  }

  /** Whether the microcontroller does not take them. */
  boolean isRefused() {
    return sends > MOST_SENDS;
  }
}
