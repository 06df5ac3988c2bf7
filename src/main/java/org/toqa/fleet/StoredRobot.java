package org.toqa.fleet;

/**
 * What the store knows of a robot when the fleet starts.
 *
 * @param outOfService whether a person has taken it out of service
 * @param held whether a person has put it on hold
 */
public record StoredRobot(
    RobotRecord record, boolean outOfService, boolean held, ChargeRecord charge) {

  public String name() {
    return record.name();
  }
}
