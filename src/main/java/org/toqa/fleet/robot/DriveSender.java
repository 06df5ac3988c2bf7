package org.toqa.fleet.robot;

import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.concurrent.atomic.AtomicReference;
import org.apache.pekko.actor.typed.ActorRef;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FleetStore;
import org.toqa.fleet.FleetStore.DriveExtension;
import org.toqa.fleet.FleetStore.StoredDrive;
import org.toqa.fleet.StoreWriter;
import org.toqa.link.message.ServerMessage;
import org.toqa.mission.Phase;
import org.toqa.motion.Trajectory;

/**
 * Sends a robot its drives: each, and each change of it, is stored before it is sent. Confined to
 * the robot's agent.
 */
final class DriveSender {
  private final String robot;
  private final CommandQueue commands;
  private final UnstoredDrives unstored;
  private final ActorRef<RobotEvent> floor;
  private Optional<StoredDrive> drive = Optional.empty();
  private boolean isLoaded;

  /**
   * The number of a drive that the robot does not have as it should, since a part is not stored.
   */
  private long refusedDrive;

  /** Asks the store for the last drive; {@link #setLoaded} brings it. */
  DriveSender(
      String robot,
      FleetStore store,
      StoreWriter writer,
      CommandQueue commands,
      ActorRef<RobotEvent> floor,
      ActorRef<RobotMessage> self) {
    this.robot = robot;
    this.commands = commands;
    this.floor = floor;
    this.unstored = new UnstoredDrives(robot, store, writer, self);
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
  void follow(RobotMessage.Follow m) {
    begin(
        new StoredDrive(
            commands.nextNumber(), m.task(), Phase.TO_GOAL, new Trajectory(m.pose(), List.of())),
        (n, _) ->
            new ServerMessage.Follow(
                n, m.task(), m.leader(), m.fingerprint(), m.offset(), m.tolerance()));
  }

  private void begin(StoredDrive next, CommandQueue.DriveCommand command) {
    store(next, commands.addBegin(next.seq(), command));
  }

  /**
   * @param command of the queue, that begins it
   */
  private void store(StoredDrive next, long command) {
    drive = Optional.of(next);
    unstored.add(new UnstoredDrives.Begin(command, next));
    floor.tell(new RobotEvent.DriveBegun(robot, next));
  }

  void extend(RobotMessage.Extend m) {
    if (drive.isEmpty() || drive.get().seq() == refusedDrive) {
      return;
    }
    StoredDrive old = drive.get();
    Optional<UnstoredDrives.Extension> merged = unstored.merge(old.seq(), m);
    if (merged.isPresent()) {
      commands.replaceChange(merged.get().command(), command(merged.get().extend()));
    } else {
      unstored.add(
          new UnstoredDrives.Extension(
              commands.addChange(old.seq(), command(m)), old.seq(), old.extensions() + 1, m));
    }
    int number = merged.isPresent() ? old.extensions() : old.extensions() + 1;
    drive = Optional.of(old.with(new DriveExtension(old.seq(), number, m.from(), m.segments())));
  }

  private static CommandQueue.DriveCommand command(RobotMessage.Extend m) {
    return (n, d) -> new ServerMessage.Extend(n, d, m.from(), m.segments(), m.released(), m.last());
  }

  void release(RobotMessage.Release m) {
    if (drive.isEmpty() || drive.get().seq() == refusedDrive) {
      return;
    }
    long number = drive.get().seq();
    unstored
        .merge(number, m)
        .ifPresentOrElse(
            merged -> commands.replaceChange(merged.command(), command(merged.extend())),
            () ->
                commands.sendInOrder(
                    number, (n, d) -> new ServerMessage.Release(n, d, m.released())));
  }

  void commandStored(long id) {
    commands.setStored(id);
    sendStored();
    unstored.settle();
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
    store(next, commands.renumberFirst(next.seq()));
  }

  void cancel(RobotMessage.Cancel m) {
    dropWaiting().ifPresent(number -> floor.tell(new RobotEvent.DriveWithdrawn(robot, number)));
    commands.send(n -> new ServerMessage.Cancel(n, m.task()));
  }

  /**
   * What waits is not sent any more.
   *
   * @return the last drive that was to begin
   */
  Optional<Long> dropWaiting() {
    unstored.withdrawWaiting();
    return commands.clear();
  }

  /** It is not sent, and is to the floor as if the robot had refused it. */
  void commandNotStored(RobotMessage.CommandNotStored m) {
    commands
        .dropNotStored(m.id())
        .ifPresent(
            dropped -> {
              refusedDrive = dropped.drive();
              unstored.drop(refusedDrive);
              sendStored();
              floor.tell(
                  new RobotEvent.CommandRejected(
                      robot, dropped.isBegun() ? refusedDrive : null, m.reason()));
            });
    unstored.settle();
  }
}
