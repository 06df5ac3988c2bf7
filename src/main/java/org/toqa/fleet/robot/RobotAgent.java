package org.toqa.fleet.robot;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
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
import org.toqa.mission.Phase;
import org.toqa.motion.Segment;
import org.toqa.motion.Trajectory;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * The server's side of one robot: it owns the link, the sequence numbers and the record of the last
 * drive, pings every 500 ms, and notices silence.
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
  private final FleetStore store;
  private final StoreWriter writer;
  private final RobotLinkFactory links;
  private RobotLink link;

  private final CommandQueue commands = new CommandQueue(this::send);
  private Optional<StoredDrive> drive = Optional.empty();
  private boolean driveKnown;
  private @Nullable Hello hello;

  private Instant now;

  /** The drives that commands not yet answered are to change, by the commands' numbers. */
  private final Map<Long, Long> changing = new HashMap<>();

  /** The number of the last clear. */
  private long lastClear;

  private final SilenceDetector silence;
  private Instant lastPing = Instant.MIN;

  public static Behavior<RobotMessage> of(
      RobotRecord robot,
      ActorRef<RobotEvent> floor,
      FleetStore store,
      RobotLinkFactory links,
      Instant now,
      FleetRuntime runtime) {
    return Supervision.resuming(
        Phrase.ROBOT_PART.with(robot.name()),
        RobotMessage.class,
        runtime,
        Behaviors.setup(
            context -> new RobotAgent(context, robot, floor, store, links, now, runtime)));
  }

  private RobotAgent(
      ActorContext<RobotMessage> context,
      RobotRecord robot,
      ActorRef<RobotEvent> floor,
      FleetStore store,
      RobotLinkFactory links,
      Instant now,
      FleetRuntime runtime) {
    super(context);
    this.robot = robot;
    this.floor = floor;
    this.store = store;
    this.now = now;
    this.silence = new SilenceDetector(now);
    AgentHealth health = AgentHealth.of(context.getSystem());
    this.writer =
        new StoreWriter(
            robot.name(),
            runtime,
            change -> health.recordLeftOut(change, runtime.monotonicNanos()));
    ActorRef<RobotMessage> self = context.getSelf();
    writer.write(
        () -> self.tell(new RobotMessage.DriveLoaded(store.drive(robot.name()))), () -> {});
    this.links = links;
    this.link = openLink();
  }

  private RobotLink openLink() {
    return links.open(robot.address(), new LinkListener(getContext().getSelf()));
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
      case RobotMessage.Drive m -> startDrive(m);
      case RobotMessage.Lead m ->
          commands.sendInOrder(
              0, (n, _) -> new ServerMessage.Lead(n, m.task(), m.tolerance(), m.followers()));
      case RobotMessage.Follow m -> follow(m);
      case RobotMessage.Extend m -> extend(m);
      case RobotMessage.Release m -> release(m.released());
      case RobotMessage.CommandStored m -> commandStored(m.id());
      case RobotMessage.CommandNotStored m -> commandNotStored(m);
      case RobotMessage.Cancel m -> cancel(m);
      case RobotMessage.Hold m ->
          commands.send(m.hold() ? ServerMessage.Hold::new : ServerMessage.Resume::new);
      case RobotMessage.Clear m -> clear(m);
      case RobotMessage.Locate m -> commands.send(n -> new ServerMessage.Locate(n, m.pose()));
      case RobotMessage.Acknowledge m -> send(new ServerMessage.AckDone(m.drive()));
      case RobotMessage.LinkOpened m -> connected(m.hello());
      case RobotMessage.MessageReceived m -> messageReceived(m.message());
      case RobotMessage.LinkClosed m -> {
        disconnected(m.why());
        floor.tell(new RobotEvent.Disconnected(robot.name(), m.why()));
      }
      case RobotMessage.LinkRefused m -> {
        disconnected(m.why().english());
        floor.tell(new RobotEvent.LinkRefused(robot.name(), m.why()));
      }
      case RobotMessage.Reconnect m -> reconnect(m.robot());
      case RobotMessage.DriveLoaded m -> driveLoaded(m.drive());
      case RobotMessage.Tick m -> tick(m.now());
      case RobotMessage.Stop m -> {
        return Behaviors.stopped();
      }
    }
    return this;
  }

  /** Who cleared a stop looked at the robot now: what cannot be sent at once is not sent later. */
  private void clear(RobotMessage.Clear m) {
    if (hello == null || commands.isWaiting()) {
      floor.tell(new RobotEvent.ClearRejected(robot.name(), "The robot could not be told."));
      return;
    }
    lastClear = commands.nextNumber();
    commands.send(new ServerMessage.Clear(lastClear, m.reasons().stream().sorted().toList()));
  }

  private void startDrive(RobotMessage.Drive m) {
    begin(
        new StoredDrive(commands.nextNumber(), m.task(), m.phase(), m.trajectory()),
        (n, _) ->
            new ServerMessage.Drive(
                n,
                m.task(),
                m.phase().number(),
                m.trajectory().start(),
                m.trajectory().segments(),
                m.released(),
                m.last(),
                m.load()));
  }

  /** What it drives then is its leader's affair, so its own trajectory is empty. */
  private void follow(RobotMessage.Follow m) {
    begin(
        new StoredDrive(
            commands.nextNumber(), m.task(), Phase.TO_GOAL, new Trajectory(m.pose(), List.of())),
        (n, _) ->
            new ServerMessage.Follow(
                n, m.task(), m.leader(), m.fingerprint(), m.offset(), m.tolerance()));
  }

  private void begin(StoredDrive next, CommandQueue.DriveCommand command) {
    storeThenSend(next, null, commands.addBegin(next.seq(), command));
    floor.tell(new RobotEvent.DriveBegun(robot.name(), next));
  }

  private void extend(RobotMessage.Extend m) {
    if (drive.isEmpty()) {
      return;
    }
    StoredDrive old = drive.get();
    List<Segment> segments = new ArrayList<>(old.trajectory().segments().subList(0, m.from()));
    segments.addAll(m.segments());
    Trajectory trajectory = new Trajectory(old.trajectory().start(), segments);
    storeThenSend(
        new StoredDrive(old.seq(), old.task(), old.phase(), trajectory),
        old.seq(),
        commands.addChange(
            old.seq(),
            (n, d) ->
                new ServerMessage.Extend(n, d, m.from(), m.segments(), m.released(), m.last())));
  }

  private void release(int released) {
    drive.ifPresent(
        old ->
            commands.sendInOrder(old.seq(), (n, d) -> new ServerMessage.Release(n, d, released)));
  }

  /**
   * @param changing the drive that the command is to change; null: it begins one
   * @param id of the command in the queue
   */
  private void storeThenSend(StoredDrive next, @Nullable Long changing, long id) {
    drive = Optional.of(next);
    ActorRef<RobotMessage> self = getContext().getSelf();
    writer.write(
        () -> store.saveDrive(robot.name(), next),
        () -> self.tell(new RobotMessage.CommandStored(id)),
        refusal ->
            self.tell(
                new RobotMessage.CommandNotStored(
                    id, changing, String.valueOf(refusal.getMessage()))));
  }

  private void commandStored(long id) {
    commands.setStored(id);
    sendStored();
  }

  private void sendStored() {
    for (OptionalLong overtaken = commands.sendStored();
        overtaken.isPresent();
        overtaken = commands.sendStored()) {
      long number = overtaken.getAsLong();
      Optional<StoredDrive> last = drive.filter(d -> d.seq() == number);
      if (last.isPresent()) {
        renumber(last.get());
      } else {
        commands.drop(number); // another one comes after it
      }
    }
  }

  private void renumber(StoredDrive old) {
    StoredDrive next =
        new StoredDrive(commands.nextNumber(), old.task(), old.phase(), old.trajectory());
    storeThenSend(next, null, commands.renumberFirst(next.seq()));
    floor.tell(new RobotEvent.DriveBegun(robot.name(), next));
  }

  private void cancel(RobotMessage.Cancel m) {
    commands
        .clear()
        .ifPresent(number -> floor.tell(new RobotEvent.DriveWithdrawn(robot.name(), number)));
    commands.send(n -> new ServerMessage.Cancel(n, m.task()));
  }

  /** It is not sent, and is to the floor as if the robot had refused it. */
  private void commandNotStored(RobotMessage.CommandNotStored m) {
    commands.dropNotStored(m.id());
    sendStored();
    floor.tell(new RobotEvent.CommandRejected(robot.name(), m.changing(), m.reason()));
  }

  private void connected(Hello said) {
    log.info(
        "{}: connected; mode {}, task {}, phase {}.",
        robot.name(),
        said.mode(),
        said.task(),
        said.phase());
    hello = said;
    commands.clear(); // what was meant for the last connection: the floor decides anew
    changing.clear();
    silence.recordHeard(now);
    silence.endSilence();
    commands.raiseNumber(said.lastSeq());
    ping();
    tellConnected();
  }

  private void driveLoaded(Optional<StoredDrive> stored) {
    driveKnown = true;
    if (drive.isEmpty()) {
      drive = stored;
      commands.raiseNumber(stored.map(StoredDrive::seq).orElse(0L));
    }
    tellConnected();
  }

  private void tellConnected() {
    if (hello != null && driveKnown) {
      floor.tell(new RobotEvent.Connected(robot.name(), hello, drive));
    }
  }

  private void messageReceived(AgentMessage message) {
    silence.recordHeard(now);
    if (silence.isSilent() && hello != null && driveKnown) {
      silence.endSilence();
      log.info("{}: heard again.", robot.name());
      floor.tell(new RobotEvent.HeardAgain(robot.name()));
    }
    switch (message) {
      case AgentMessage.State state ->
          floor.tell(new RobotEvent.StateReported(robot.name(), state));
      case AgentMessage.Done done ->
          floor.tell(
              new RobotEvent.PhaseEnded(
                  robot.name(),
                  new AgentMessage.PhaseEnd(done.task(), done.phase(), done.drive())));
      case AgentMessage.Reject reject -> {
        log.info("{}: refused command {}: {}", robot.name(), reject.seq(), reject.reason());
        floor.tell(
            reject.seq() == lastClear
                ? new RobotEvent.ClearRejected(robot.name(), reject.reason())
                : new RobotEvent.CommandRejected(
                    robot.name(), changing.remove(reject.seq()), reject.reason()));
      }
      case AgentMessage.Hello ignored -> {}
      case AgentMessage.FollowerReport ignored -> {}
      case AgentMessage.Ack(long acknowledged) -> {
        changing.remove(acknowledged);
        if (drive.isPresent() && drive.get().seq() == acknowledged) {
          floor.tell(new RobotEvent.DriveAccepted(robot.name(), acknowledged));
        }
      }
    }
  }

  private void disconnected(String why) {
    if (hello != null) {
      log.warn("{}: connection lost: {}", robot.name(), why);
    }
    hello = null;
  }

  private void reconnect(RobotRecord paired) {
    link.close();
    disconnected("it was paired anew");
    floor.tell(new RobotEvent.Disconnected(robot.name(), "it was paired anew"));
    robot = paired;
    link = openLink();
  }

  private void tick(Instant time) {
    now = time;
    if (hello != null && !lastPing.plus(PING_INTERVAL).isAfter(now)) {
      ping();
    }
    if (silence.detectSilence(now)) {
      floor.tell(new RobotEvent.FellSilent(robot.name(), silence.lastHeard()));
    }
  }

  private void ping() {
    lastPing = now;
    commands.ping();
  }

  private void send(ServerMessage message) {
    if (hello != null) {
      switch (message) {
        case ServerMessage.Extend extend -> changing.put(extend.seq(), extend.drive());
        case ServerMessage.Release release -> changing.put(release.seq(), release.drive());
        default -> {}
      }
      link.send(message);
    }
  }

  private Behavior<RobotMessage> stopped() {
    link.close();
    writer.close();
    return this;
  }

  /** Turns the link's calls into messages. */
  private record LinkListener(ActorRef<RobotMessage> self) implements RobotLink.Listener {
    @Override
    public void connected(Hello said) {
      self.tell(new RobotMessage.LinkOpened(said));
    }

    @Override
    public void received(AgentMessage message) {
      self.tell(new RobotMessage.MessageReceived(message));
    }

    @Override
    public void disconnected(String sentence) {
      self.tell(new RobotMessage.LinkClosed(sentence));
    }

    @Override
    public void refused(Sentence sentence) {
      self.tell(new RobotMessage.LinkRefused(sentence));
    }
  }
}
