package org.toqa.agent.control;

import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.agent.chassis.ChassisCommand;
import org.toqa.agent.chassis.ChassisCommand.MoveAt;
import org.toqa.agent.chassis.SharedLoad;
import org.toqa.agent.formation.FormationFollower;
import org.toqa.geometry.Twist;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.AgentMessage.Role;

/** A robot that keeps its place beside a leader. */
record Following(FormationFollower follower) implements Activity {

  /** Whether it follows for this task. */
  boolean isFor(@Nullable Long task) {
    return Objects.equals(task, follower.order().task());
  }

  @Override
  public Role role() {
    return Role.FOLLOWER;
  }

  @Override
  public Optional<SharedLoad> sharedLoad() {
    return Optional.ofNullable(follower.order().carries())
        .map(part -> SharedLoad.of(follower.order().task(), part));
  }

  @Override
  public Optional<DriveRun> drive() {
    return Optional.empty();
  }

  /** The follower law sees every tick, also those in which the robot may not move. */
  @Override
  public ChassisCommand steer(Tick tick) {
    Twist velocity = follower.steer(tick.pose(), tick.now());
    return tick.canMove() ? new MoveAt(velocity) : ChassisCommand.MoveAt.STANDSTILL;
  }

  @Override
  public boolean isPhaseOver(double now) {
    return false;
  }

  @Override
  public Optional<Fault> fault(double now) {
    return follower.fault();
  }

  @Override
  public Activity cancel(@Nullable Long task) {
    return isFor(task) ? Alone.IDLE : this;
  }

  @Override
  public Activity withoutDrive() {
    return this;
  }
}
