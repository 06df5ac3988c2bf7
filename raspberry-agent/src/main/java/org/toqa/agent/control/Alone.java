package org.toqa.agent.control;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.agent.chassis.ChassisCommand;
import org.toqa.agent.chassis.SharedLoad;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.AgentMessage.Role;

/** A robot by itself: it drives, or it is stopped. */
record Alone(Optional<DriveRun> drive) implements Activity {

  /** A robot that has nothing to do. */
  static final Alone IDLE = new Alone(Optional.empty());

  @Override
  public Role role() {
    return Role.ALONE;
  }

  @Override
  public Optional<SharedLoad> sharedLoad() {
    return Optional.empty();
  }

  @Override
  public ChassisCommand steer(Tick tick) {
    return drive.map(run -> run.steer(tick)).orElse(ChassisCommand.MoveAt.STANDSTILL);
  }

  @Override
  public boolean isPhaseOver(double now) {
    return drive.filter(DriveRun::isAtEndOfPhase).isPresent();
  }

  @Override
  public Optional<Fault> fault(double now) {
    return Optional.empty();
  }

  @Override
  public Activity cancel(@Nullable Long task) {
    return this;
  }

  @Override
  public Activity withoutDrive() {
    return IDLE;
  }
}
