package org.toqa.fleet.floor;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.MissionEvent.OfRobot;
import org.toqa.mission.TaskPlace;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** Tells from a robot's condition what the mission that it works for must know. */
final class RobotWatch {
  /** A shorter loss is nothing to bother a person with. */
  private static final Duration ASK_AFTER = Duration.ofSeconds(5);

  private static final int LONGEST_CODE = 60;

  private final Duration reassignAfter;

  /**
   * @param reassignAfter a robot that is silent for so long has failed
   */
  RobotWatch(Duration reassignAfter) {
    this.reassignAfter = reassignAfter;
  }

  /**
   * The same condition may be told again and again.
   *
   * @param place where the robot is, or the load that it carries with others; null where nobody
   *     knows
   */
  Optional<OfRobot> missionEvent(FloorRobot robot, @Nullable TaskPlace place, Instant now) {
    if (!robot.settings.isInService()) {
      if (robot.isHeard() && !robot.hasStopped()) {
        return Optional.empty(); // where it will stop is not known yet
      }
      return Optional.of(new MissionEvent.RobotWithdrawn(robot.name(), place));
    }
    Optional<Instant> silentSince = robot.reported.contact().silentSince();
    if (silentSince.isPresent()) {
      return lostEvent(robot, place, Duration.between(silentSince.get(), now));
    }
    if (robot.reported.mode() == Mode.ERROR) {
      if (robot.reported.isMoving()) {
        return Optional.empty();
      }
      return Optional.of(new MissionEvent.RobotFailed(robot.name(), errorClause(robot), place));
    }
    Sentence fault = robot.obedience.fault();
    if (fault != null) {
      return robot.reported.isMoving()
          ? Optional.empty()
          : Optional.of(new MissionEvent.RobotFailed(robot.name(), fault, place));
    }
    return robot.isFit()
        ? Optional.of(new MissionEvent.RobotRecovered(robot.name()))
        : Optional.empty();
  }

  private Optional<OfRobot> lostEvent(
      FloorRobot robot, @Nullable TaskPlace place, Duration silence) {
    if (silence.compareTo(reassignAfter) >= 0) {
      return Optional.of(
          new MissionEvent.RobotFailed(robot.name(), Phrase.IS_NOT_HEARD_OF.with(), place));
    }
    return silence.compareTo(ASK_AFTER) >= 0
        ? Optional.of(new MissionEvent.RobotLost(robot.name(), place))
        : Optional.empty();
  }

  private static Sentence errorClause(FloorRobot robot) {
    List<Fault> errors = robot.reported.report().errors();
    if (errors.isEmpty()) {
      return Phrase.REPORTS_ERROR.with();
    }
    String code = errors.getFirst().code();
    return Phrase.REPORTS_CODE.with(
        code.length() > LONGEST_CODE ? code.substring(0, LONGEST_CODE) : code);
  }
}
