package org.toqa.fleet.robot;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.apache.pekko.actor.typed.ActorRef;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.RateLimit;
import org.toqa.fleet.RobotMessageKind;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.AgentMessage.State;

/**
 * Hands a robot's states to its floor, no oftener than a floor has to know them: the newest waits
 * until it is time, and a fault that came or went is not passed over. What is left out is counted,
 * and the floor is told once that it is too much. Confined to the robot's agent.
 */
final class ReportForwarder {
  /** A robot sends five, and one on each change. */
  private static final int STATES_A_SECOND = 25;

  private static final int FAULT_CHANGES_A_SECOND = 10;
  private static final int ENDS_A_SECOND = 5;
  private static final int STRAY_ANSWERS_A_SECOND = 20;

  /** Of those that end soon; see {@code link.channel.Backoff}. */
  private static final int CONNECTIONS_A_MINUTE = 10;

  /** So old is what sensors beside the link see at most. */
  private static final Duration RANGES_LAST = Duration.ofMillis(500);

  private static final Duration SECOND = Duration.ofSeconds(1);

  private final String robot;
  private final ActorRef<RobotEvent> floor;
  private final Supplier<Instant> now;
  private final PerceptFilter percepts = new PerceptFilter();
  private final FloodMeter meter;
  private final RateLimit states;
  private final RateLimit faultChanges;
  private final RateLimit ends;
  private final RateLimit strayAnswers;
  private final RateLimit connections;
  private @Nullable Hello hello;
  private @Nullable State held;

  /** What sensors beside the link see, until the next state tells from where. */
  private RobotMessage.@Nullable RangesHeard ranges;

  private Instant rangesHeardAt = Instant.EPOCH;

  /**
   * @param now of the time that ticks bring
   */
  ReportForwarder(
      String robot, ActorRef<RobotEvent> floor, AgentHealth health, Supplier<Instant> now) {
    this.robot = robot;
    this.floor = floor;
    this.now = now;
    meter = new FloodMeter(health);
    states = new RateLimit(STATES_A_SECOND, STATES_A_SECOND, SECOND, now);
    faultChanges = new RateLimit(FAULT_CHANGES_A_SECOND, FAULT_CHANGES_A_SECOND, SECOND, now);
    ends = new RateLimit(2 * ENDS_A_SECOND, ENDS_A_SECOND, SECOND, now);
    strayAnswers = new RateLimit(STRAY_ANSWERS_A_SECOND, STRAY_ANSWERS_A_SECOND, SECOND, now);
    connections =
        new RateLimit(CONNECTIONS_A_MINUTE, CONNECTIONS_A_MINUTE, Duration.ofMinutes(1), now);
  }

  /**
   * @param said null: it has no connection
   */
  void setConnection(@Nullable Hello said) {
    hello = said;
    held = null;
    percepts.reset();
    if (said != null && !connections.tryAcquire()) {
      leaveOut(RobotMessageKind.CONNECTION, 1);
    }
  }

  void receive(State state) {
    if (held != null && !faults(held).equals(faults(state)) && faultChanges.tryAcquire()) {
      flush();
    }
    if (held != null) {
      leaveOut(RobotMessageKind.STATE, 1);
    }
    held = state;
    if (states.tryAcquire()) {
      flush();
    }
  }

  /** What they see counts with the next state, if that comes soon. */
  void receiveRanges(RobotMessage.RangesHeard heard) {
    ranges = heard;
    rangesHeardAt = now.get();
  }

  /** The state with what sensors beside the link see from there. */
  private State withRanges(State state, Hello said) {
    RobotMessage.RangesHeard heard = ranges;
    ranges = null;
    if (heard == null || rangesHeardAt.plus(RANGES_LAST).isBefore(now.get())) {
      return state;
    }
    List<Vec2> obstacles = new ArrayList<>(state.obstacles());
    for (int i = 0; i < heard.ranges().size(); i++) {
      double range = heard.ranges().get(i);
      if (range < said.sensorRange()) { // else it sees nothing
        Vec2 inFrame = new Vec2(said.footprint() / 2 + range, 0).rotated(heard.angles().get(i));
        obstacles.add(state.pose().compose(new Pose(inFrame.x(), inFrame.y(), 0)).position());
      }
    }
    return state.withObstacles(obstacles);
  }

  /** Hands on what waits; to be called before anything that the robot said after it. */
  void flush() {
    State state = held;
    held = null;
    if (state != null && hello != null) {
      floor.tell(new RobotEvent.StateReported(robot, limited(state, hello)));
    }
  }

  private State limited(State reported, Hello said) {
    State state = withRanges(reported, said);
    List<Vec2> believed = percepts.believable(state, said, now.get());
    int unbelieved = state.obstacles().size() - believed.size();
    if (unbelieved == 0) {
      return state;
    }
    leaveOut(RobotMessageKind.OBSTACLE, unbelieved);
    return state.withObstacles(believed);
  }

  /** Whether the end of a phase is handed on; it comes again where it is not. */
  boolean takesPhaseEnd() {
    boolean isTaken = ends.tryAcquire();
    if (!isTaken) {
      leaveOut(RobotMessageKind.DONE, 1);
    }
    return isTaken;
  }

  /**
   * An answer has come that nothing waits for.
   *
   * @return whether there are still few of them
   */
  boolean takesStrayAnswer() {
    boolean isTaken = strayAnswers.tryAcquire();
    if (!isTaken) {
      leaveOut(RobotMessageKind.ANSWER, 1);
    }
    return isTaken;
  }

  void recordPassedOver(LinkInbox.PassedOver passed) {
    leaveOut(RobotMessageKind.STATE, passed.superseded());
    leaveOut(RobotMessageKind.UNREADABLE, passed.unreadable());
    leaveOut(RobotMessageKind.BACKLOG, passed.overflows());
  }

  private void leaveOut(RobotMessageKind kind, long count) {
    if (count > 0 && meter.record(kind, count, now.get())) {
      floor.tell(new RobotEvent.FloodBegan(robot, kind));
    }
  }

  /** To be called at each tick. */
  void update() {
    if (held != null && states.tryAcquire()) {
      flush();
    }
    if (meter.detectRecovery(now.get())) {
      floor.tell(new RobotEvent.FloodEnded(robot));
    }
  }

  private static Set<String> faults(State state) {
    return state.errors().stream().map(Fault::code).collect(Collectors.toSet());
  }
}
