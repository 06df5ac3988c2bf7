package org.toqa.fleet;

import java.time.Instant;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FleetStore.StoredDrive;
import org.toqa.geometry.Pose;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.motion.Trajectory;

/** What a robot agent is told: by its floor, by its link, by its store, by the clock. */
sealed interface RobotMessage {

  /** Drive this way, all of it released, and end the phase with it. */
  record Drive(@Nullable Long task, int phase, Trajectory way) implements RobotMessage {}

  record Cancel(@Nullable Long task) implements RobotMessage {}

  record Locate(Pose pose) implements RobotMessage {}

  /** What followed from the end of this drive is stored. */
  record Acknowledge(long drive) implements RobotMessage {}

  record LinkUp(Hello hello) implements RobotMessage {}

  record Heard(AgentMessage message) implements RobotMessage {}

  record LinkDown(String why) implements RobotMessage {}

  record DriveLoaded(Optional<StoredDrive> drive) implements RobotMessage {}

  record DriveStored(StoredDrive drive) implements RobotMessage {}

  record Tick(Instant now) implements RobotMessage {}

  record Stop() implements RobotMessage {}
}
