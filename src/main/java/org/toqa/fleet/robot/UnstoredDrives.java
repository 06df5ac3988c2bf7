package org.toqa.fleet.robot;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.apache.pekko.actor.typed.ActorRef;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FleetStore;
import org.toqa.fleet.FleetStore.DriveExtension;
import org.toqa.fleet.FleetStore.StoredDrive;
import org.toqa.fleet.StoreWriter;

/**
 * Has a robot's drives and their extensions stored, one after the other. What comes while one is
 * with the store waits here, and extensions of a drive that wait become one: less is written where
 * the store is slow, and little waits however long it is away. Confined to the robot's agent.
 */
final class UnstoredDrives {
  private final String robot;
  private final FleetStore store;
  private final StoreWriter writer;
  private final ActorRef<RobotMessage> self;
  private final Deque<Change> waiting = new ArrayDeque<>();

  /** The one that is with the store. */
  private @Nullable Change storing;

  /** What is to be stored before a command is sent. */
  sealed interface Change {
    /** Of the command in the queue. */
    long command();

    /** The number of the drive. */
    long drive();
  }

  record Begin(long command, StoredDrive begun) implements Change {
    @Override
    public long drive() {
      return begun.seq();
    }
  }

  /**
   * @param number of the extension
   */
  record Extension(long command, long drive, int number, RobotMessage.Extend extend)
      implements Change {
    private Extension with(RobotMessage.Extend other) {
      return new Extension(command, drive, number, other);
    }
  }

  /**
   * @param self is told of each that it is stored, or never can be
   */
  UnstoredDrives(String robot, FleetStore store, StoreWriter writer, ActorRef<RobotMessage> self) {
    this.robot = robot;
    this.store = store;
    this.writer = writer;
    this.self = self;
  }

  void add(Change change) {
    waiting.addLast(change);
    storeNext();
  }

  /**
   * Adds to the extension that waits.
   *
   * @return what that is now; empty: none waits last
   */
  Optional<Extension> merge(long drive, RobotMessage.Extend next) {
    return replaceLast(drive, waits -> waits.with(waits.extend().followedBy(next)));
  }

  /** As above, for a release. */
  Optional<Extension> merge(long drive, RobotMessage.Release next) {
    return replaceLast(drive, waits -> waits.with(waits.extend().followedBy(next)));
  }

  private Optional<Extension> replaceLast(long drive, UnaryOperator<Extension> replacement) {
    if (waiting.peekLast() instanceof Extension last && last.drive() == drive) {
      Extension merged = replacement.apply(last);
      waiting.removeLast();
      waiting.addLast(merged);
      return Optional.of(merged);
    }
    return Optional.empty();
  }

  /** The store has one of them, or never will: the next one is stored. */
  void settle() {
    storing = null;
    storeNext();
  }

  /**
   * Nothing that waits is sent any more. A number that was given to a drive is stored all the same.
   */
  void withdrawWaiting() {
    Optional<Change> lastBegin =
        waiting.stream().filter(Begin.class::isInstance).reduce((first, next) -> next);
    waiting.clear();
    lastBegin.ifPresent(waiting::addLast);
  }

  /** What waits of the drive is not stored. */
  void drop(long drive) {
    waiting.removeIf(change -> change.drive() == drive);
  }

  private void storeNext() {
    if (storing != null || waiting.isEmpty()) {
      return;
    }
    Change next = waiting.removeFirst();
    storing = next;
    long id = next.command();
    writer.write(
        () -> save(next),
        () -> self.tell(new RobotMessage.CommandStored(id)),
        refusal ->
            self.tell(new RobotMessage.CommandNotStored(id, String.valueOf(refusal.getMessage()))));
  }

  private void save(Change change) {
    switch (change) {
      case Begin(long _, StoredDrive begun) -> store.saveDrive(robot, begun);
      case Extension(long _, long drive, int number, RobotMessage.Extend extend) ->
          store.saveExtension(
              robot, new DriveExtension(drive, number, extend.from(), extend.segments()));
    }
  }
}
