package org.toqa.fleet.robot;

import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import java.util.OptionalLong;
import org.apache.pekko.actor.typed.ActorRef;
import org.apache.pekko.actor.typed.Behavior;
import org.apache.pekko.actor.typed.PostStop;
import org.apache.pekko.actor.typed.javadsl.AbstractBehavior;
import org.apache.pekko.actor.typed.javadsl.ActorContext;
import org.apache.pekko.actor.typed.javadsl.Behaviors;
import org.apache.pekko.actor.typed.javadsl.Receive;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.fleet.FleetRuntime;
import org.toqa.fleet.FleetStore;
import org.toqa.fleet.FleetStore.StoredDrive;
import org.toqa.fleet.RobotRecord;
import org.toqa.fleet.StoreWriter;
import org.toqa.link.RobotLink;
import org.toqa.link.RobotLinkFactory;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.ServerMessage;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * The server's side of one robot: it owns the link, pings every 500 ms, notices silence, and hands
 * on no more of what the robot says than a floor has to know.
 *
 * <p>A drive is stored before it is sent. Holds, resumes and cancels do not wait for that; a cancel
 * also drops what waits. What is told while the link is down is dropped: the next hello says what
 * the robot knows, and the floor decides anew.
 */
public final class RobotAgent extends AbstractBehavior<RobotMessage> {
  private static final Logger log = LoggerFactory.getLogger(RobotAgent.class);
  private static final Duration PING_INTERVAL = Duration.ofMillis(500);

  private RobotRecord robot;
  private final ActorRef<RobotEvent> floor;
  private final RobotLinkFactory links;
  private RobotLink link;

  /** Of the present link. */
  private LinkInbox inbox;

  private final CommandQueue commands = new CommandQueue(this::send);
  private final UnansweredCommands unanswered;
  private final DriveSender drives;
  private final ClearSender clears;
  private final ReportForwarder reports;
  private final TaskBidder bidder;
  private @Nullable Hello hello;

  /** What the robot said last of itself by the present link. */
  private AgentMessage.@Nullable State lastState;

  private Instant now;
  private final SilenceDetector silence;
  private Instant lastPing = Instant.MIN;

  /** Whether it was connected anew since it answered last. */
  private boolean isConnectedAnew;

  /** Of the command by which the robot was told last where it is; 0: it never was. */
  private long locateNumber;

  /** Until then nobody looks whether it answers. */
  private Instant leftOutUntil = Instant.MIN;

  /**
   * @param writer of its floor, which stores the drives of all its robots
   */
  public static Behavior<RobotMessage> of(
      RobotRecord robot,
      ActorRef<RobotEvent> floor,
      FleetStore store,
      StoreWriter writer,
      RobotLinkFactory links,
      Instant now,
      FleetRuntime runtime) {
    return Supervision.resuming(
        Phrase.ROBOT_PART.with(robot.name()),
        RobotMessage.class,
        runtime,
        Behaviors.setup(
            context -> new RobotAgent(context, robot, floor, store, writer, links, now, runtime)));
  }

  private RobotAgent(
      ActorContext<RobotMessage> context,
      RobotRecord robot,
      ActorRef<RobotEvent> floor,
      FleetStore store,
      StoreWriter writer,
      RobotLinkFactory links,
      Instant now,
      FleetRuntime runtime) {
    super(context);
    this.robot = robot;
    this.floor = floor;
    this.links = links;
    this.now = now;
    this.silence = new SilenceDetector(now);
    this.unanswered = new UnansweredCommands(now);
    AgentHealth health = AgentHealth.of(context.getSystem());
    RobotAgents.of(context.getSystem()).add(robot, context.getSelf());
    this.drives = new DriveSender(robot.name(), store, writer, commands, floor, context.getSelf());
    this.clears = new ClearSender(robot.name(), commands::send);
    this.reports = new ReportForwarder(robot.name(), floor, health, () -> this.now);
    this.bidder = new TaskBidder(runtime.threadPerTaskExecutor("bids-" + robot.name()));
    this.inbox = openInbox(context.getSelf());
    this.link = links.open(robot.address(), inbox);
  }

  private static LinkInbox openInbox(ActorRef<RobotMessage> self) {
    return new LinkInbox(filled -> self.tell(new RobotMessage.InboxFilled(filled)));
  }

  @Override
  public Receive<RobotMessage> createReceive() {
    return newReceiveBuilder()
        .onAnyMessage(this::handle)
        .onSignal(PostStop.class, signal -> stopped())
        .build();
  }

  private Behavior<RobotMessage> handle(RobotMessage message) {
    switch (message) {
      case RobotMessage.Drive m -> {
        lookAnew();
        drives.start(m);
      }
      case RobotMessage.Follow m -> {
        lookAnew();
        drives.follow(m);
      }
      case RobotMessage.Extend m -> drives.extend(m);
      case RobotMessage.Release m -> drives.release(m.released());
      case RobotMessage.LendRoom m -> drives.lendRoom(m.room());
      case RobotMessage.RoomReturned _ -> drives.roomReturned();
      case RobotMessage.CommandStored m -> drives.commandStored(m.id());
      case RobotMessage.CommandNotStored m -> drives.commandNotStored(m);
      case RobotMessage.Cancel m -> drives.cancel(m);
      case RobotMessage.Hold m ->
          commands.send(m.hold() ? ServerMessage.Hold::new : ServerMessage.Resume::new);
      case RobotMessage.Clear m -> clear(m);
      case RobotMessage.Locate m -> {
        locateNumber = commands.nextNumber();
        commands.send(new ServerMessage.Locate(locateNumber, m.pose()));
      }
      case RobotMessage.Act m ->
          commands.send(
              n ->
                  new ServerMessage.Act(
                      n,
                      m.task(),
                      m.phase().number(),
                      m.action(),
                      ServerMessage.Frame.MAP,
                      m.target(),
                      m.load()));
      case RobotMessage.AcknowledgeAct m -> send(new ServerMessage.AckActed(m.act()));
      case RobotMessage.RangesHeard m -> reports.receiveRanges(m);
      case RobotMessage.Negotiate m ->
          bidder.answer(m.message(), robot, hello, lastState, m.replyTo());
      case RobotMessage.RecordChanged m -> robot = m.robot();
      case RobotMessage.Acknowledge m -> send(new ServerMessage.AckDone(m.drive()));
      case RobotMessage.InboxFilled m -> takeInbox(m.inbox());
      case RobotMessage.LinkOpened m -> connected(m.hello());
      case RobotMessage.MessageReceived m -> messageReceived(m.message());
      case RobotMessage.LinkClosed m -> {
        disconnected(m.why());
        floor.tell(new RobotEvent.Disconnected(robot.name(), m.why()));
      }
      case RobotMessage.LinkRefused m -> {
        disconnected(m.why());
        floor.tell(new RobotEvent.LinkRefused(robot.name(), m.why()));
      }
      case RobotMessage.Reconnect m -> reconnect(m.robot());
      case RobotMessage.DriveLoaded m -> driveLoaded(m.drive());
      case RobotMessage.Tick m -> tick(m.now().get());
      case RobotMessage.Stop m -> {
        return Behaviors.stopped();
      }
    }
    return this;
  }

  /** Of a link that was closed nothing counts any more. */
  private void takeInbox(LinkInbox filled) {
    try {
      RobotMessage next = filled.poll();
      if (next != null && filled == inbox) {
        reports.recordPassedOver(filled.takePassedOver());
        handle(next);
      }
    } finally { // or nothing would ever be taken again
      filled.finish();
    }
  }

  /** Who cleared a stop looked at the robot now: what cannot be sent at once is not sent later. */
  private void clear(RobotMessage.Clear m) {
    if (hello == null || commands.isWaiting()) {
      rejectClear(Phrase.CLEAR_NOT_ANSWERED.with(robot.name()));
    } else {
      clears.begin(commands.nextNumber(), m.reasons(), now);
    }
  }

  private void rejectClear(Sentence why) {
    floor.tell(new RobotEvent.ClearRejected(robot.name(), why));
  }

  private void connected(Hello said) {
    log.info(
        "{}: connected; mode {}, task {}, phase {}.",
        robot.name(),
        said.mode(),
        said.task(),
        said.phase());
    hello = said;
    lastState = null;
    commands.clear(); // what was meant for the last connection: the floor decides anew
    unanswered.clear();
    reports.setConnection(said);
    clears.reconnected(said.lastSeq()).ifPresent(this::rejectClear);
    silence.recordHeard(now);
    silence.endSilence();
    commands.raiseNumber(said.lastSeq());
    ping();
    tellConnected();
  }

  private void driveLoaded(Optional<StoredDrive> stored) {
    drives.setLoaded(stored);
    tellConnected();
  }

  private void tellConnected() {
    if (hello != null && drives.isLoaded()) {
      floor.tell(new RobotEvent.Connected(robot.name(), hello, drives.drive()));
    }
  }

  private void messageReceived(AgentMessage message) {
    switch (message) {
      case AgentMessage.State state -> {
        recordHeard(); // who only answers tells nothing of itself
        lastState = state;
        reports.receive(state);
      }
      case AgentMessage.Done done -> phaseEnded(done);
      case AgentMessage.Acted acted -> {
        if (reports.takesPhaseEnd()) {
          reports.flush();
          floor.tell(new RobotEvent.Acted(robot.name(), acted.end()));
        }
      }
      case AgentMessage.Reject reject -> rejected(reject);
      case AgentMessage.Ack(long seq) -> acknowledged(seq);
      case AgentMessage.Hello ignored -> {}
      case AgentMessage.FollowerReport ignored -> {}
    }
  }

  private void recordHeard() {
    silence.recordHeard(now);
    if (silence.isSilent() && hello != null && drives.isLoaded()) {
      silence.endSilence();
      log.info("{}: heard again.", robot.name());
      floor.tell(new RobotEvent.HeardAgain(robot.name()));
    }
  }

  private void phaseEnded(AgentMessage.Done done) {
    if (reports.takesPhaseEnd()) {
      reports.flush();
      floor.tell(
          new RobotEvent.PhaseEnded(
              robot.name(), new AgentMessage.PhaseEnd(done.task(), done.phase(), done.drive())));
    }
  }

  private void rejected(AgentMessage.Reject reject) {
    Optional<OptionalLong> awaited = takeAnswer(reject.seq());
    if (awaited.isEmpty() && !reports.takesStrayAnswer()) {
      return;
    }
    log.info("{}: refused command {}: {}", robot.name(), reject.seq(), reject.reason());
    if (clears.settle(reject.seq())) {
      rejectClear(Phrase.REFUSED_A_COMMAND.with(robot.name(), reject.reason()));
    } else if (drives.isRoom(reject.seq())) {
      floor.tell(new RobotEvent.RoomRefused(robot.name()));
    } else if (awaited.isPresent()) {
      reports.flush();
      OptionalLong changed = awaited.get();
      commands.withdrawLed(reject.seq());
      floor.tell(
          new RobotEvent.CommandRejected(
              robot.name(),
              changed.isPresent() ? changed.getAsLong() : null,
              reject.reason(),
              drives.isDrive(reject.seq()) || drives.isLead(reject.seq())));
    }
  }

  private void acknowledged(long seq) {
    if (takeAnswer(seq).isEmpty()) {
      var _ = reports.takesStrayAnswer();
      return;
    }
    clears.settle(seq);
    drives.leadTaken(seq);
    if (drives.isRoom(seq)) {
      reports.flush();
      floor.tell(new RobotEvent.RoomTaken(robot.name()));
    }
    if (seq == locateNumber) {
      reports.flush();
      floor.tell(new RobotEvent.Located(robot.name()));
    }
    if (drives.isDrive(seq)) {
      reports.flush();
      floor.tell(new RobotEvent.DriveAccepted(robot.name(), seq));
    }
  }

  private Optional<OptionalLong> takeAnswer(long seq) {
    isConnectedAnew &= !unanswered.isOwed(seq);
    return unanswered.take(seq);
  }

  /** A connection whose one half is dead is mended so; what was sent over it counts no more. */
  private void endDeafConnection() {
    log.warn("{}: does not answer commands.", robot.name());
    if (isConnectedAnew) {
      leftOutUntil = now.plus(RobotEvent.LEFT_OUT_FOR);
      floor.tell(new RobotEvent.NotAnswering(robot.name()));
    }
    isConnectedAnew = true;
    reconnect(robot);
  }

  /** Who left it out tries it again: it owes nothing from before. */
  private void lookAnew() {
    if (leftOutUntil.isAfter(now)) {
      leftOutUntil = Instant.MIN;
      unanswered.forgive();
    }
  }

  private void disconnected(Sentence why) {
    if (hello != null) {
      log.warn("{}: connection lost: {}", robot.name(), why.english());
    }
    hello = null;
    reports.setConnection(null);
  }

  private void reconnect(RobotRecord paired) {
    link.close();
    Sentence why = Phrase.IS_CONNECTED_ANEW.with(robot.name());
    disconnected(why);
    floor.tell(new RobotEvent.Disconnected(robot.name(), why));
    robot = paired;
    inbox = openInbox(getContext().getSelf());
    link = links.open(robot.address(), inbox);
  }

  private void tick(Instant time) {
    now = time;
    if (hello != null && !lastPing.plus(PING_INTERVAL).isAfter(now)) {
      ping();
    }
    reports.recordPassedOver(inbox.takePassedOver());
    reports.update();
    clears.repeat(now).ifPresent(this::rejectClear);
    boolean isOverdue = unanswered.isOverdue(now, hello != null && !silence.isSilent());
    if (isOverdue && !leftOutUntil.isAfter(now)) {
      endDeafConnection();
    }
    if (silence.detectSilence(now)) {
      floor.tell(new RobotEvent.FellSilent(robot.name(), silence.lastHeard(), inbox.fault()));
    }
  }

  private void ping() {
    lastPing = now;
    commands.ping();
  }

  private void send(ServerMessage message) {
    if (hello != null) {
      if (message instanceof ServerMessage.Command command) {
        unanswered.add(command);
      }
      link.send(message);
    }
  }

  private Behavior<RobotMessage> stopped() {
    RobotAgents.of(getContext().getSystem()).remove(getContext().getSelf());
    link.close();
    return this;
  }
}
