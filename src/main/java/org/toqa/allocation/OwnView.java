package org.toqa.allocation;

import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;
import org.toqa.wording.Sentence;

/**
 * A robot as its own agent knows it.
 *
 * @param maxLoad kilograms
 * @param diameter metres
 * @param speed metres a second, straight on
 * @param position metres, map frame
 * @param battery 0 to 1; null where it is not known
 * @param obstacle why it can be given nothing now, follows its name; null: it can
 */
public record OwnView(
    String robot,
    double maxLoad,
    double diameter,
    double speed,
    Vec2 position,
    @Nullable Double battery,
    @Nullable Sentence obstacle) {

  /** What a robot is that can be given a task. */
  public static OwnView of(Candidate robot) {
    return new OwnView(
        robot.robot(),
        robot.maxLoad(),
        robot.diameter(),
        robot.speed(),
        robot.position(),
        robot.battery(),
        null);
  }

  /** Of a robot that can be given nothing. */
  public static OwnView unable(String robot, Sentence obstacle) {
    return new OwnView(robot, 0, 1, 1, Vec2.ZERO, null, obstacle);
  }

  Candidate candidate() {
    return new Candidate(
        robot,
        maxLoad,
        diameter,
        speed,
        true, // who carries together is not the agent's affair
        position,
        position,
        battery,
        Availability.FREE,
        null);
  }
}
