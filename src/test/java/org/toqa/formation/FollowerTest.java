package org.toqa.formation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.toqa.formation.Follower.Trouble;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;

class FollowerTest {

  private static final Pose LEADER = new Pose(5, 5, Math.PI / 2);
  private static final Twist AHEAD = new Twist(0.25, 0, 0);

  private final Follower follower =
      new Follower(new SingleIntegratorLaw(Gains.DEFAULT), new Vec2(-1, 0.5), 0.05, 0);

  @Test
  void placeTurnsWithTheLeadersHeading() {
    follower.receive(LEADER, Twist.ZERO, 0);
    // 1 m behind a leader that faces north is 1 m south of it, 0.5 m to its left is west of it
    follower.steer(new Pose(4.5, 4, Math.PI / 2), 0);

    assertEquals(0, follower.error(), 1e-9);
    assertEquals(Optional.empty(), follower.trouble());
  }

  @Test
  void standsUntilItsLeaderHasSpoken() {
    assertEquals(Twist.ZERO, follower.steer(new Pose(0, 0, 0), 3));
    assertEquals(Optional.of(Trouble.NO_LEADER_YET), follower.trouble());
  }

  @Test
  void leaderIsTakenToMoveOnAsItDid() {
    follower.receive(LEADER, AHEAD, 1);
    follower.steer(new Pose(4.5, 4.1, Math.PI / 2), 1.4); // 0.4 s at 0.25 m/s

    assertEquals(0, follower.error(), 1e-9);
  }

  @Test
  void stopsWithoutItsLeaderForSixTenthsOfASecondAndGoesOnWhenItSpeaks() {
    follower.receive(LEADER, AHEAD, 1);
    Pose place = new Pose(4.5, 4.15, Math.PI / 2);
    assertNotEquals(Twist.ZERO, follower.steer(place, 1.58));
    assertEquals(Twist.ZERO, follower.steer(place, 1.62));
    assertEquals(Optional.of(Trouble.LEADER_LOST), follower.trouble());

    follower.receive(new Pose(5, 5.15, Math.PI / 2), Twist.ZERO, 2);
    follower.steer(place, 2);
    assertEquals(Optional.empty(), follower.trouble());
  }

  @Test
  void drivesBackFromOutOfPlaceAndIsWellOnlyNearIt() {
    follower.receive(LEADER, Twist.ZERO, 0);
    Twist back = follower.steer(new Pose(4.5, 3.94, Math.PI / 2), 0);
    assertEquals(Optional.of(Trouble.OUT_OF_PLACE), follower.trouble());
    assertEquals(0.1, back.vx(), 1e-9); // 2/s times 0.06 m, at most 0.1 m/s

    follower.steer(new Pose(4.5, 3.97, Math.PI / 2), 0);
    assertEquals(Optional.of(Trouble.OUT_OF_PLACE), follower.trouble());
    follower.steer(new Pose(4.5, 3.98, Math.PI / 2), 0);
    assertEquals(Optional.empty(), follower.trouble());
  }

  @Test
  void doesNotDriveAcrossTheFloorToAPlaceThatCannotBeRight() {
    follower.receive(LEADER, AHEAD, 0);

    assertEquals(Twist.ZERO, follower.steer(new Pose(0, 0, 0), 0));
    assertEquals(Optional.of(Trouble.TOO_FAR), follower.trouble());
  }
}
