package org.toqa.fleet;

import java.time.Duration;
import org.jspecify.annotations.Nullable;

/**
 * What the store knows of a robot when the fleet starts.
 *
 * @param outOfService whether a person has taken it out of service
 * @param held whether a person has put it on hold
 * @param carried whether it was carried to this floor, and has not taken since where it stands
 * @param toldLoad kilograms that it said it carries; null: it was never connected
 * @param place null where nothing is known of it, or a person said that it is not there any more
 */
public record StoredRobot(
    RobotRecord record,
    boolean outOfService,
    boolean held,
    boolean carried,
    ChargeRecord charge,
    @Nullable Double toldLoad,
    @Nullable LastPlace place) {

  /** Of one that was just added: it is in service, and has not been connected. */
  public static StoredRobot added(RobotRecord record) {
    return new StoredRobot(
        record,
        false,
        false,
        false,
        new ChargeRecord(record.name(), Duration.ZERO, null),
        null,
        null);
  }

  public String name() {
    return record.name();
  }
}
