package org.toqa.fleet.floor;

import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.apache.pekko.actor.typed.ActorRef;
import org.apache.pekko.pattern.StatusReply;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Answer;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.robot.RobotMessage;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * Clears the stops of one robot's hardware, by the word of a person who was shown them: the word is
 * stored first, and is sent only if nothing has changed by then.
 */
final class ClearCommandHandler {
  private final FloorState state;
  private final FloorReporter reports;
  private final ActorRef<FloorMessage> self;

  ClearCommandHandler(FloorState state, FloorReporter reports, ActorRef<FloorMessage> self) {
    this.state = state;
    this.reports = reports;
    this.self = self;
  }

  void clearStops(FloorMessage.ClearStops m) {
    FloorRobot robot = state.robots.get(m.robot());
    Sentence objection = robot == null ? null : objection(robot, m.reasons());
    if (robot == null || objection != null) {
      reject(m, objection);
      return;
    }
    EventRecord event =
        state.historyEvent(
            EventKind.ROBOT_STOP_CLEARED,
            m.robot(),
            m.user(),
            Phrase.ROBOT_STOP_CLEARED.with(
                m.user(),
                m.robot(),
                m.reasons().stream().sorted().collect(Collectors.joining(", "))));
    state.writer.tryOnce(
        () -> state.store.addEvents(List.of(event)),
        () -> self.tell(new FloorMessage.ClearStored(m)),
        failure -> m.replyTo().tell(StatusReply.error(failure)));
  }

  void clearStored(FloorMessage.ClearStops m) {
    FloorRobot robot = state.robots.get(m.robot());
    Sentence objection = robot == null ? null : objection(robot, m.reasons());
    if (robot == null || objection != null) {
      reject(m, objection);
      return;
    }
    robot.cleared.begin(m.reasons(), state.now);
    robot.agent.tell(new RobotMessage.Clear(m.reasons()));
    m.replyTo().tell(StatusReply.success(new Answer.Accepted<>(reports.view(robot))));
  }

  /**
   * @param objection null: there is no such robot
   */
  private static void reject(FloorMessage.ClearStops m, @Nullable Sentence objection) {
    m.replyTo()
        .tell(
            StatusReply.success(
                objection == null
                    ? FloorState.unknownRobot(m.robot())
                    : new Answer.Conflict<>(objection, null)));
  }

  private static @Nullable Sentence objection(FloorRobot robot, Set<String> reasons) {
    if (!robot.isHeard()) {
      return Phrase.CLEAR_WHEN_CONNECTED.with(robot.name());
    }
    List<Fault> stops = robot.reported.report().errors().stream().filter(Fault::clearable).toList();
    if (stops.isEmpty()) {
      return Phrase.NOTHING_TO_CLEAR.with(robot.name());
    }
    return stops.stream().map(Fault::code).collect(Collectors.toSet()).equals(reasons)
        ? null
        : Phrase.STOPS_HAVE_CHANGED.with(
            robot.name(), stops.stream().map(Fault::text).collect(Collectors.joining(" ")));
  }
}
