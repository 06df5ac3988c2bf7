package org.toqa.fleet;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
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
import org.toqa.fleet.FleetStore.StoredDrive;
import org.toqa.link.RobotLink;
import org.toqa.link.RobotLinks;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.ServerMessage;
import org.toqa.link.message.ServerMessage.Command;
import org.toqa.motion.Segment;
import org.toqa.motion.Trajectory;
import org.toqa.wording.Sentence;

/**
 * The server's side of one robot: it owns the link, the sequence numbers and the record of the last
 * drive, pings every 500 ms, and notices silence.
 *
 * <p>A drive is stored before it is sent. What is told while the link is down is dropped: the next
 * hello says what the robot knows, and the floor decides anew.
 */
final class RobotAgent extends AbstractBehavior<RobotMessage> {
  private static final Logger log = LoggerFactory.getLogger(RobotAgent.class);
  private static final Duration PING_EVERY = Duration.ofMillis(500);
  private static final Duration LOST_AFTER = Duration.ofSeconds(2);

  private RobotRecord robot;
  private final ActorRef<FloorMessage> floor;
  private final FleetStore store;
  private final StoreWriter writer;
  private final RobotLinks links;
  private RobotLink link;

  private long seq;
  private Optional<StoredDrive> drive = Optional.empty();
  private boolean driveKnown;
  private @Nullable Hello hello;

  /** Counts the connections: what was meant for an old one is not sent on the next. */
  private long connection;

  /** The number of the last message that was sent. */
  private long sent;

  /** Messages that wait for the store. */
  private int unsent;

  private boolean silent;
  private Instant now;

  /** The drives that commands on their way are to change, by the commands' numbers. */
  private final Map<Long, Long> changing = new HashMap<>();

  private Instant lastHeard;
  private Instant lastPing = Instant.MIN;

  static Behavior<RobotMessage> of(
      RobotRecord robot,
      ActorRef<FloorMessage> floor,
      FleetStore store,
      RobotLinks links,
      Instant now) {
    return AgentFleet.goingOn(
        Behaviors.setup(context -> new RobotAgent(context, robot, floor, store, links, now)));
  }

  private RobotAgent(
      ActorContext<RobotMessage> context,
      RobotRecord robot,
      ActorRef<FloorMessage> floor,
      FleetStore store,
      RobotLinks links,
      Instant now) {
    super(context);
    this.robot = robot;
    this.floor = floor;
    this.store = store;
    this.now = now;
    this.lastHeard = now;
    this.writer = new StoreWriter(robot.name());
    ActorRef<RobotMessage> self = context.getSelf();
    writer.write(
        () -> self.tell(new RobotMessage.DriveLoaded(store.drive(robot.name()))), () -> {});
    this.links = links;
    this.link = open();
  }

  private RobotLink open() {
    return links.open(robot.address(), new Mailbox(getContext().getSelf()));
  }

  @Override
  public Receive<RobotMessage> createReceive() {
    return newReceiveBuilder()
        .onAnyMessage(this::on)
        .onSignal(PostStop.class, signal -> closed())
        .build();
  }

  private Behavior<RobotMessage> on(RobotMessage message) {
    switch (message) {
      case RobotMessage.Drive m -> begin(m);
      case RobotMessage.Lead m ->
          sendInOrder(new ServerMessage.Lead(++seq, m.task(), m.tolerance(), m.followers()));
      case RobotMessage.Follow m -> follow(m);
      case RobotMessage.Extend m -> extend(m);
      case RobotMessage.Release m -> release(m.released());
      case RobotMessage.DriveStored m -> stored(m);
      case RobotMessage.Cancel m -> sendInOrder(new ServerMessage.Cancel(++seq, m.task()));
      case RobotMessage.Hold m ->
          sendInOrder(m.hold() ? new ServerMessage.Hold(++seq) : new ServerMessage.Resume(++seq));
      case RobotMessage.Locate m -> sendInOrder(new ServerMessage.Locate(++seq, m.pose()));
      case RobotMessage.Acknowledge m -> send(new ServerMessage.AckDone(m.drive()));
      case RobotMessage.LinkUp m -> connected(m.hello());
      case RobotMessage.Heard m -> heard(m.message());
      case RobotMessage.LinkDown m -> {
        disconnected(m.why());
        floor.tell(new FloorMessage.Disconnected(robot.name(), m.why()));
      }
      case RobotMessage.LinkRefused m -> {
        disconnected(m.why().english());
        floor.tell(new FloorMessage.LinkRefused(robot.name(), m.why()));
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

  private void begin(RobotMessage.Drive m) {
    StoredDrive next = new StoredDrive(++seq, m.task(), m.phase(), m.way());
    storeThenSend(
        next,
        new ServerMessage.Drive(
            next.seq(),
            m.task(),
            m.phase(),
            m.way().start(),
            m.way().segments(),
            m.released(),
            m.last(),
            m.load()));
    floor.tell(new FloorMessage.DriveBegun(robot.name(), next));
  }

  /** What it drives then is its leader's affair, so its own way is empty. */
  private void follow(RobotMessage.Follow m) {
    StoredDrive next = new StoredDrive(++seq, m.task(), 2, new Trajectory(m.stands(), List.of()));
    storeThenSend(
        next,
        new ServerMessage.Follow(
            next.seq(), m.task(), m.leader(), m.fingerprint(), m.offset(), m.tolerance()));
    floor.tell(new FloorMessage.DriveBegun(robot.name(), next));
  }

  private void extend(RobotMessage.Extend m) {
    if (drive.isEmpty()) {
      return;
    }
    StoredDrive old = drive.get();
    List<Segment> segments = new ArrayList<>(old.way().segments().subList(0, m.from()));
    segments.addAll(m.segments());
    Trajectory way = new Trajectory(old.way().start(), segments);
    storeThenSend(
        new StoredDrive(old.seq(), old.task(), old.phase(), way),
        new ServerMessage.Extend(++seq, old.seq(), m.from(), m.segments(), m.released(), m.last()));
  }

  private void release(int released) {
    drive.ifPresent(d -> sendInOrder(new ServerMessage.Release(++seq, d.seq(), released)));
  }

  private void storeThenSend(StoredDrive next, Command message) {
    drive = Optional.of(next);
    unsent++;
    long asked = connection;
    ActorRef<RobotMessage> self = getContext().getSelf();
    writer.write(
        () -> store.saveDrive(robot.name(), next),
        () -> self.tell(new RobotMessage.DriveStored(asked, message)));
  }

  /** Behind everything that still waits for the store, since sequence numbers must rise. */
  private void sendInOrder(Command message) {
    if (unsent == 0) {
      send(message);
      return;
    }
    unsent++;
    long asked = connection;
    ActorRef<RobotMessage> self = getContext().getSelf();
    writer.write(() -> {}, () -> self.tell(new RobotMessage.DriveStored(asked, message)));
  }

  private void stored(RobotMessage.DriveStored m) {
    unsent--;
    if (m.connection() == connection) {
      send(m.message());
    } // else the hello of the new connection made the floor decide anew
  }

  private void connected(Hello said) {
    log.info(
        "{}: connected; mode {}, task {}, phase {}.",
        robot.name(),
        said.mode(),
        said.task(),
        said.phase());
    hello = said;
    connection++;
    changing.clear();
    lastHeard = now;
    silent = false;
    seq = Math.max(seq, said.lastSeq());
    ping();
    tellConnected();
  }

  private void driveLoaded(Optional<StoredDrive> stored) {
    driveKnown = true;
    if (drive.isEmpty()) {
      drive = stored;
      seq = Math.max(seq, stored.map(StoredDrive::seq).orElse(0L));
    }
    tellConnected();
  }

  private void tellConnected() {
    if (hello != null && driveKnown) {
      floor.tell(new FloorMessage.Connected(robot.name(), hello, drive));
    }
  }

  private void heard(AgentMessage message) {
    lastHeard = now;
    if (silent && hello != null && driveKnown) {
      silent = false;
      log.info("{}: heard again.", robot.name());
      floor.tell(new FloorMessage.HeardAgain(robot.name()));
    }
    switch (message) {
      case AgentMessage.State state -> floor.tell(new FloorMessage.Heard(robot.name(), state));
      case AgentMessage.Done done ->
          floor.tell(
              new FloorMessage.PhaseEnded(
                  robot.name(),
                  new AgentMessage.PhaseEnd(done.task(), done.phase(), done.drive())));
      case AgentMessage.Reject reject -> {
        log.info("{}: refused command {}: {}", robot.name(), reject.seq(), reject.reason());
        floor.tell(
            new FloorMessage.Rejected(
                robot.name(), changing.remove(reject.seq()), reject.reason()));
      }
      case AgentMessage.Hello ignored -> {}
      case AgentMessage.Keep ignored -> {}
      case AgentMessage.Ack(long acknowledged) -> {
        changing.remove(acknowledged);
        if (drive.isPresent() && drive.get().seq() == acknowledged) {
          floor.tell(new FloorMessage.DriveTaken(robot.name(), acknowledged));
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
    floor.tell(new FloorMessage.Disconnected(robot.name(), "it was paired anew"));
    robot = paired;
    link = open();
  }

  private void tick(Instant time) {
    now = time;
    if (hello != null && !lastPing.plus(PING_EVERY).isAfter(now)) {
      ping();
    }
    if (!silent && lastHeard.plus(LOST_AFTER).isBefore(now)) {
      silent = true;
      floor.tell(new FloorMessage.Silent(robot.name(), lastHeard));
    }
  }

  private void ping() {
    lastPing = now;
    // a number of the past where others wait for the store: theirs must not be old when they come
    send(new ServerMessage.Ping(unsent == 0 ? ++seq : sent));
  }

  private void send(ServerMessage message) {
    if (hello != null) {
      switch (message) {
        case ServerMessage.Extend extend -> changing.put(extend.seq(), extend.drive());
        case ServerMessage.Release release -> changing.put(release.seq(), release.drive());
        default -> {}
      }
      link.send(message);
      sent = message instanceof Command command ? command.seq() : sent;
    }
  }

  private Behavior<RobotMessage> closed() {
    link.close();
    writer.close();
    return this;
  }

  /** Turns the link's calls into messages. */
  private record Mailbox(ActorRef<RobotMessage> self) implements RobotLink.Listener {
    @Override
    public void connected(Hello said) {
      self.tell(new RobotMessage.LinkUp(said));
    }

    @Override
    public void received(AgentMessage message) {
      self.tell(new RobotMessage.Heard(message));
    }

    @Override
    public void disconnected(String sentence) {
      self.tell(new RobotMessage.LinkDown(sentence));
    }

    @Override
    public void refused(Sentence sentence) {
      self.tell(new RobotMessage.LinkRefused(sentence));
    }
  }
}
