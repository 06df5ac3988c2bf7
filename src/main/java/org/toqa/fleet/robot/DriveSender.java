package org.toqa.fleet.robot;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.concurrent.atomic.AtomicReference;
import org.apache.pekko.actor.typed.ActorRef;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FleetStore;
import org.toqa.fleet.FleetStore.StoredDrive;
import org.toqa.fleet.StoreWriter;
import org.toqa.link.message.ServerMessage;
import org.toqa.mission.Phase;
import org.toqa.motion.PassingRoom;
import org.toqa.motion.Segment;
import org.toqa.motion.Trajectory;

/**
 * Sends a robot its drives: each, and each change of it, is stored before it is sent. Confined to
 * the robot's agent.
 */
final class DriveSender {
  private final String robot;
  private final FleetStore store;
  private final StoreWriter writer;
  private final CommandQueue commands;
  private final ActorRef<RobotEvent> floor;
  private final ActorRef<RobotMessage> self;
  private Optional<StoredDrive> drive = Optional.empty();
  private boolean isLoaded;

  /** Of the command by which the robot was lent room last; 0: it never was. */
  private long roomNumber;

  /** Of the last command by which the robot was to lead; 0: there was none. */
  private long leadNumber;

  /** Asks the store for the last drive; {@link #setLoaded} brings it. */
  DriveSender(
      String robot,
      FleetStore store,
      StoreWriter writer,
      CommandQueue commands,
      ActorRef<RobotEvent> floor,
      ActorRef<RobotMessage> self) {
    this.robot = robot;
    this.store = store;
    this.writer = writer;
    this.commands = commands;
    this.floor = floor;
    this.self = self;
    AtomicReference<@Nullable StoredDrive> last = new AtomicReference<>();
    writer.write(
        () -> last.set(store.drive(robot).orElse(null)),
        () -> self.tell(new RobotMessage.DriveLoaded(Optional.ofNullable(last.get()))));
  }

  void setLoaded(Optional<StoredDrive> stored) {
    isLoaded = true;
    if (drive.isEmpty()) {
      drive = stored;
      commands.raiseNumber(stored.map(StoredDrive::seq).orElse(0L));
    }
  }

  /** Whether the last drive is known. */
  boolean isLoaded() {
    return isLoaded;
  }

  /** The last drive that the robot was sent or is being sent. */
  Optional<StoredDrive> drive() {
    return drive;
  }

  void start(RobotMessage.Drive m) {
    RobotMessage.Lead lead = m.lead();
    if (lead != null) {
      lead(lead);
    }
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

  private void lead(RobotMessage.Lead m) {
    commands.sendInOrder(
        0,
        (n, _) -> {
          leadNumber = n;
          return new ServerMessage.Lead(n, m.task(), m.tolerance(), m.followers(), m.carries());
        });
  }

  /** What it drives then is its leader's affair, so its own trajectory is empty. */
  void follow(RobotMessage.Follow m) {
    begin(
        new StoredDrive(
            commands.nextNumber(), m.task(), Phase.TO_GOAL, new Trajectory(m.pose(), List.of())),
        (n, _) ->
            new ServerMessage.Follow(
                n, m.task(), m.leader(), m.fingerprint(), m.offset(), m.tolerance(), m.carries()));
  }

  private void begin(StoredDrive next, CommandQueue.DriveCommand command) {
    begin(next, commands.addBegin(next.seq(), command));
    floor.tell(new RobotEvent.DriveBegun(robot, next));
  }

  void extend(RobotMessage.Extend m) {
    if (drive.isEmpty()) {
      return;
    }
    StoredDrive old = drive.get();
    List<Segment> segments = new ArrayList<>(old.trajectory().segments().subList(0, m.from()));
    segments.addAll(m.segments());
    Trajectory trajectory = new Trajectory(old.trajectory().start(), segments);
    storeThenSend(
        new StoredDrive(old.seq(), old.task(), old.phase(), trajectory),
        () -> store.saveDriveEnd(robot, old.seq(), m.from(), m.segments()),
        old.seq(),
        commands.addChange(
            old.seq(),
            (n, d) ->
                new ServerMessage.Extend(n, d, m.from(), m.segments(), m.released(), m.last())));
  }

  void release(int released) {
    drive.ifPresent(
        old ->
            commands.sendInOrder(old.seq(), (n, d) -> new ServerMessage.Release(n, d, released)));
  }

  /** It is stored before it is sent: who starts after a crash keeps it free. */
  void lendRoom(PassingRoom room) {
    if (drive.isEmpty()) {
      return;
    }
    StoredDrive on = drive.get();
    storeThenSend(
        on,
        () -> store.saveRoom(robot, on.seq(), room),
        on.seq(),
        commands.addChange(
            on.seq(),
            (n, d) -> {
              roomNumber = n;
              return new ServerMessage.Room(
                  n, d, room.from(), room.to(), room.left(), room.right(), room.zone());
            }));
  }

  /** The robot has no room any more. */
  void roomReturned() {
    drive.ifPresent(on -> writer.write(() -> store.saveRoom(robot, on.seq(), null), () -> {}));
  }

  /** Whether that is the number of the last drive. */
  boolean isDrive(long number) {
    return drive.filter(last -> last.seq() == number).isPresent();
  }

  /** Whether that is the number of the last command by which the robot was to lead. */
  boolean isLead(long number) {
    return leadNumber == number;
  }

  /** Whether that is the number of the command by which the robot was lent room last. */
  boolean isRoom(long number) {
    return roomNumber == number;
  }

  private void begin(StoredDrive next, long id) {
    storeThenSend(next, () -> store.saveDrive(robot, next), null, id);
  }

  /**
   * @param next what the robot has to drive from then on
   * @param change stores that
   * @param changing the drive that the command is to change; null: it begins one
   * @param id of the command in the queue
   */
  private void storeThenSend(StoredDrive next, Runnable change, @Nullable Long changing, long id) {
    drive = Optional.of(next);
    writer.write(
        robot,
        change,
        () -> self.tell(new RobotMessage.CommandStored(id)),
        refusal ->
            self.tell(
                new RobotMessage.CommandNotStored(
                    id, changing, String.valueOf(refusal.getMessage()))));
  }

  void commandStored(long id) {
    commands.setStored(id);
    sendStored();
  }

  /** The robot has taken the command of that number: if it leads by that, it may drive. */
  void leadTaken(long number) {
    commands.leadTaken(number);
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
    begin(next, commands.renumberFirst(next.seq()));
    floor.tell(new RobotEvent.DriveBegun(robot, next));
  }

  void cancel(RobotMessage.Cancel m) {
    commands.clear().ifPresent(number -> floor.tell(new RobotEvent.DriveWithdrawn(robot, number)));
    commands.send(n -> new ServerMessage.Cancel(n, m.task()));
  }

  /** It is not sent, and is to the floor as if the robot had refused it. */
  void commandNotStored(RobotMessage.CommandNotStored m) {
    commands.dropNotStored(m.id());
    sendStored();
    floor.tell(new RobotEvent.CommandRejected(robot, m.changing(), m.reason(), false));
  }
}
