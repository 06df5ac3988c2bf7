package org.toqa.formation;

import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;

/**
 * What a follower was last told of its leader.
 *
 * @param pose map frame
 * @param twist in the leader's frame
 * @param seconds when it was so, on the follower's monotonic clock
 */
record LeaderState(Pose pose, Twist twist, double seconds) {

  /** Where the leader is by now, if it moves on as it did: along its arc, not along a chord. */
  Pose at(double now) {
    return pose.advanced(twist, Math.max(0, now - seconds));
  }
}
