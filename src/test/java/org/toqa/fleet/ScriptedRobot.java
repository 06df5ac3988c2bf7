package org.toqa.fleet;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.link.RobotLink;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Ack;
import org.toqa.link.message.AgentMessage.Done;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.Reject;
import org.toqa.link.message.AgentMessage.Role;
import org.toqa.link.message.AgentMessage.Speed;
import org.toqa.link.message.AgentMessage.State;
import org.toqa.link.message.ServerMessage;
import org.toqa.link.message.ServerMessage.AckDone;
import org.toqa.link.message.ServerMessage.Cancel;
import org.toqa.link.message.ServerMessage.Command;
import org.toqa.link.message.ServerMessage.Drive;
import org.toqa.link.message.ServerMessage.Extend;
import org.toqa.link.message.ServerMessage.Follow;
import org.toqa.link.message.ServerMessage.Hold;
import org.toqa.link.message.ServerMessage.Lead;
import org.toqa.link.message.ServerMessage.Ping;
import org.toqa.link.message.ServerMessage.Release;
import org.toqa.link.message.ServerMessage.Resume;
import org.toqa.motion.Trajectory;

/**
 * A robot at the other end of the link, without a link: it answers by the contract, drives one
 * released segment at each step of the test, and sees what the test lets it see. In a formation a
 * follower is where its leader takes it, and the leader stands while a follower does not follow.
 */
public final class ScriptedRobot {
  static final double FOOTPRINT = 0.255;

  private final String name;
  private Pose pose;
  private List<Vec2> obstacles = List.of();
  private double battery = 0.8;
  private double footprint = FOOTPRINT;
  private int stepsASegment = 1;
  private int steps;
  private boolean mute;
  private boolean stuck;
  private boolean held;
  private boolean endsFirst;
  private @Nullable Fault fault;
  private final List<Command> obeyed = new ArrayList<>();
  private RobotLink.@Nullable Listener listener;
  private boolean connected;

  private @Nullable Trajectory trajectory;
  private @Nullable Long task;
  private @Nullable Done done;
  private int phase;
  private long drive;
  private int segment;
  private int released;
  private boolean last;
  private long lastSeq;
  private @Nullable Lead leading;
  private @Nullable Follow following;

  /** The task whose formation it has brought to its goal. */
  private @Nullable Long ended;

  private Function<String, ScriptedRobot> others = name -> this;

  ScriptedRobot(String name, Vec2 at) {
    this.name = name;
    this.pose = new Pose(at.x(), at.y(), 0);
  }

  /** How it finds the robots that it carries together with. */
  synchronized void setPeers(Function<String, ScriptedRobot> byName) {
    others = byName;
  }

  synchronized void setObstacles(Vec2... points) {
    obstacles = List.of(points);
  }

  /**
   * @param share of 0 to 1
   */
  synchronized void setBattery(double share) {
    battery = share;
  }

  /** It drives a segment only after so many steps. */
  synchronized void setStepsPerSegment(int stepsForOne) {
    stepsASegment = stepsForOne;
  }

  /**
   * To be said before the server hears of it.
   *
   * @param diameter metres
   */
  synchronized void setFootprint(double diameter) {
    footprint = diameter;
  }

  /** From now on it says nothing, and drives nothing. */
  synchronized void fallSilent() {
    mute = true;
  }

  synchronized void speakAgain() {
    mute = false;
  }

  /** It speaks, and does not move though it may. */
  synchronized void setStuck(boolean stuck) {
    this.stuck = stuck;
  }

  /** Its drive is at an end a moment before it hears the next change of that. */
  synchronized void endBeforeNextChange() {
    endsFirst = true;
  }

  synchronized boolean isAwaitingChange() {
    return endsFirst;
  }

  /** From now on its body cannot drive. */
  synchronized void breakDown(String code) {
    fault = new Fault(code, "It cannot drive.");
  }

  synchronized void repair() {
    fault = null;
  }

  synchronized boolean isHeld() {
    return held;
  }

  /** Falls silent for good with its connection; what comes next begins with a hello. */
  synchronized void loseConnection() {
    mute = true;
    connected = false;
    Objects.requireNonNull(listener).disconnected("cut");
  }

  /** All that it was told and did, in order, without pings. */
  synchronized List<Command> obeyed() {
    return List.copyOf(obeyed);
  }

  synchronized boolean isDriving() {
    return drive != 0;
  }

  synchronized Vec2 position() {
    return pose.position();
  }

  synchronized RobotLink link(RobotLink.Listener heard) {
    listener = heard;
    connected = false;
    return new RobotLink() {
      @Override
      public void send(ServerMessage message) {
        hear(message);
      }

      @Override
      public void close() {
        closed(heard);
      }
    };
  }

  private synchronized void closed(RobotLink.Listener heard) {
    listener = heard.equals(listener) ? null : listener;
  }

  /** A moment of its life: a segment, and what it says then. */
  synchronized void step() {
    if (mute || listener == null) {
      return;
    }
    if (!connected) {
      connected = true;
      listener.connected(hello());
      return;
    }
    steps++;
    boolean mayMove =
        !stuck && !held && fault == null && steps % stepsASegment == 0 && missing() == null;
    keepPlace();
    if (trajectory != null && segment < released && mayMove) {
      segment++;
      pose = trajectory.poseAfter(segment);
    }
    if (trajectory != null && !held && last && segment == trajectory.segments().size()) {
      done = new Done(task, phase, drive);
      ended = leading == null ? ended : task;
      leading = null;
      trajectory = null;
      drive = 0;
    }
    listener.received(state());
    if (done != null) {
      listener.received(done);
    }
  }

  /** A follower that does not follow; null while all do, or it leads none. */
  private @Nullable String missing() {
    Lead lead = leading;
    return lead == null
        ? null
        : lead.followers().stream()
            .map(ServerMessage.Follower::robot)
            .filter(follower -> !others.apply(follower).isKeepingPlace(lead.task()))
            .findFirst()
            .orElse(null);
  }

  private synchronized boolean isKeepingPlace(long task) {
    return following != null && following.task() == task && !mute && !held && fault == null;
  }

  private synchronized boolean hasEnded(long task) {
    return ended != null && ended == task;
  }

  private synchronized Pose pose() {
    return pose;
  }

  private void keepPlace() {
    Follow order = following;
    if (order == null) {
      return;
    }
    ScriptedRobot leader = others.apply(order.leader());
    pose = leader.pose().compose(new Pose(order.offset().x(), order.offset().y(), 0));
    if (leader.hasEnded(order.task())) {
      done = new Done(task, phase, drive);
      following = null;
      drive = 0;
    }
  }

  private synchronized void hear(ServerMessage message) {
    if (!connected) {
      return;
    }
    if (message instanceof AckDone ack) {
      if (done != null && done.drive() == ack.done()) {
        task = done.phase() == 3 ? null : task;
        done = null;
      }
    } else if (message instanceof Command command && command.seq() > lastSeq) {
      lastSeq = command.seq();
      boolean isChange = command instanceof Extend || command instanceof Release;
      if (isChange && (endsFirst || trajectory == null)) {
        endsFirst = false;
        trajectory = null;
        drive = 0;
        say(new Reject(command.seq(), "There is no such drive any more; the robot has none."));
        return;
      }
      obey(command);
      say(new Ack(command.seq()));
    }
  }

  private void obey(Command command) {
    if (!(command instanceof Ping)) {
      obeyed.add(command);
    }
    switch (command) {
      case Lead l -> {
        leading = l;
        ended = null;
      }
      case Follow f -> {
        following = f;
        task = f.task();
        phase = 2;
        drive = f.seq();
        segment = 0;
        released = 0;
        done = null;
      }
      case Hold h -> held = true;
      case Resume r -> held = false;
      case Drive d -> {
        trajectory = new Trajectory(d.start(), d.segments());
        task = d.task();
        phase = d.phase();
        drive = d.seq();
        segment = 0;
        released = d.released();
        last = d.last();
        done = null;
      }
      case Extend e -> {
        Trajectory old = Objects.requireNonNull(trajectory);
        var segments = new ArrayList<>(old.segments().subList(0, e.from()));
        segments.addAll(e.segments());
        trajectory = new Trajectory(old.start(), segments);
        released = e.released();
        last = e.last();
      }
      case Release r -> released = r.released();
      case Cancel c -> {
        if (Objects.equals(c.task(), task)) {
          trajectory = null;
          leading = null;
          following = null;
          task = null;
          drive = 0;
          done = null;
        }
      }
      default -> {}
    }
  }

  private void say(AgentMessage message) {
    if (!mute && listener != null) {
      listener.received(message);
    }
  }

  private Mode mode() {
    if (fault != null) {
      return Mode.ERROR;
    }
    if (held) {
      return Mode.HOLDING;
    }
    if (following != null) {
      return Mode.FOLLOWING;
    }
    return drive == 0 ? Mode.IDLE : Mode.DRIVING;
  }

  private Role role() {
    if (following != null) {
      return Role.FOLLOWER;
    }
    return leading == null ? Role.ALONE : Role.LEADER;
  }

  private List<Fault> faults() {
    if (fault != null) {
      return List.of(fault);
    }
    String missing = missing();
    return missing == null
        ? List.of()
        : List.of(
            new Fault("FORMATION_STOPPED", "The group stands: " + missing + " does not answer."));
  }

  private Hello hello() {
    return new Hello(
        AgentMessage.VERSION,
        name,
        5,
        0.5,
        footprint,
        true,
        pose,
        mode(),
        task,
        phase,
        role(),
        drive,
        segment,
        released,
        lastSeq,
        null);
  }

  private State state() {
    return new State(
        0,
        true,
        pose,
        new Speed(0, 0),
        mode(),
        task,
        phase,
        role(),
        drive,
        segment,
        released,
        battery,
        List.of(),
        obstacles,
        faults());
  }
}
