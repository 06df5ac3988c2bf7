package org.toqa.agent.firmware;

import java.util.List;
import java.util.Set;
import org.toqa.geometry.Pose;

/**
 * What the microcontroller reports.
 *
 * @param sequence the number of the command that is answered
 * @param powerCycle another number after every start
 * @param stampMillis since the start; wraps around after 49 days
 * @param counts of the wheels' encoders; they wrap around
 * @param odometry moved since the start, in the frame of the place where it was then
 * @param ranges metres, from right to left; empty while a sensor is silent or tells no distance
 * @param batteryVolts volts of the whole battery
 * @param missingFloor floor sensors that see no floor, one bit each
 * @param pressedSwitches switches 2 to 4, one bit each; the first one stops the robot
 * @param temperature of the motor drivers, degrees Celsius
 * @param freeSegments how many more segments its queue has room for
 * @param segmentsDriven how many of the path; wraps around after 65,536
 * @param coveredSeconds of the next one's planned time
 * @param pace as a share of the planned speed, 0 to 1
 * @param path the number of the path that it drives, or drove last; 0 where there was none
 * @param badFrames how many it has received
 * @param lostBytes how many it had no room for
 */
public record FirmwareStatus(
    int sequence,
    Answer answer,
    State state,
    Set<StopReason> stopReasons,
    int powerCycle,
    long stampMillis,
    List<Integer> counts,
    Pose odometry,
    List<Double> ranges,
    double batteryVolts,
    int missingFloor,
    int pressedSwitches,
    int temperature,
    int freeSegments,
    int segmentsDriven,
    double coveredSeconds,
    double pace,
    int path,
    int badFrames,
    int lostBytes) {

  /** To the last good command, in the order of the codes. */
  public enum Answer {
    NONE,
    DONE,
    QUEUE_FULL,
    STOPPED,
    OUT_OF_RANGE,
    UNKNOWN_KIND,
    NOT_CLEARED,
    NOT_ON_PATH,
    MOVES,
    NO_ARM
  }

  /** In the order of the codes; those of a path are while it drives one by itself. */
  public enum State {
    STOPPED,
    STANDING,
    DRIVING,
    PATH_STANDING,
    PATH_DRIVING
  }

  /** Whether it drives by itself, or stands at the end of what it has to drive. */
  public boolean isOnPath() {
    return state == State.PATH_STANDING || state == State.PATH_DRIVING;
  }

  /** Whether its wheels turn, or are told to. */
  boolean isMoving() {
    return state == State.DRIVING || state == State.PATH_DRIVING;
  }

  public FirmwareStatus {
    stopReasons = Set.copyOf(stopReasons);
    counts = List.copyOf(counts);
    ranges = List.copyOf(ranges);
  }
}
