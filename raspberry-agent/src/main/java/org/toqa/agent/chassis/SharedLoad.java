package org.toqa.agent.chassis;

import org.toqa.geometry.Vec2;
import org.toqa.link.message.ServerMessage.CarriedPart;

/**
 * What a robot has of a load that lies on several.
 *
 * @param task for which they carry it
 * @param share kilograms that it is to bear
 * @param weight kilograms of the whole load
 * @param point where it holds the load, metres, in the robot's frame
 * @param middle of the load as it is picked up, metres, map frame
 */
public record SharedLoad(long task, double share, double weight, Vec2 point, Vec2 middle) {

  public static SharedLoad of(long task, CarriedPart part) {
    return new SharedLoad(task, part.share(), part.load(), part.point(), part.middle());
  }
}
