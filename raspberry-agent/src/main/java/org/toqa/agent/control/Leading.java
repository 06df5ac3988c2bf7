package org.toqa.agent.control;

import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.agent.chassis.ChassisCommand;
import org.toqa.agent.chassis.SharedLoad;
import org.toqa.agent.formation.FormationLeader;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.AgentMessage.Role;

/** A robot that leads a formation; its drive is phase 2 of the task. */
record Leading(FormationLeader leader, Optional<DriveRun> drive) implements Activity {

  @Override
  public Role role() {
    return Role.LEADER;
  }

  @Override
  public Optional<SharedLoad> sharedLoad() {
    return Optional.ofNullable(leader.order().carries())
        .map(part -> SharedLoad.of(leader.order().task(), part));
  }

  @Override
  public ChassisCommand steer(Tick tick) {
    return drive
        .map(run -> run.steerAsLeader(tick, leader.paceLimits(tick.now()), leader.pace(tick.now())))
        .orElse(ChassisCommand.MoveAt.STANDSTILL);
  }

  /** Whether it stops for a follower's sake, and still moves. */
  boolean isBraking(double now) {
    return leader.pace(now) == 0 && drive.filter(run -> !run.isStanding()).isPresent();
  }

  @Override
  public boolean isPhaseOver(double now) {
    return drive.filter(DriveRun::isAtEndOfPhase).isPresent() && leader.canEnd(now);
  }

  @Override
  public Optional<Fault> fault(double now) {
    return drive.isPresent() ? leader.fault(now) : Optional.empty();
  }

  @Override
  public Activity cancel(@Nullable Long task) {
    return Objects.equals(task, leader.order().task()) ? new Alone(drive) : this;
  }

  @Override
  public Activity withoutDrive() {
    return new Leading(leader, Optional.empty());
  }
}
