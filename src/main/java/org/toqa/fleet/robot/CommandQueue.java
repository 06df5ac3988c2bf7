package org.toqa.fleet.robot;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.Consumer;
import java.util.function.LongFunction;
import org.jspecify.annotations.Nullable;
import org.toqa.link.message.ServerMessage;
import org.toqa.link.message.ServerMessage.Command;

/**
 * Numbers the commands for one robot as they are sent. Drives and their changes are sent in order,
 * each once it is stored; what stops the robot or lets it go on overtakes them. A leader's drive
 * waits until the robot has taken the lead: without that it would leave its followers.
 *
 * <p>A drive is stored under the number that it is sent with. One that was overtaken would come
 * with a number of the past, which a robot does not obey: it gets another number first. Confined to
 * the robot's agent.
 */
final class CommandQueue {
  private final Consumer<Command> link;
  private final Deque<Entry> waiting = new ArrayDeque<>();
  private long lastId;
  private long lastNumber;
  private long lastSent;

  /** Of the lead that the robot has not answered and drives wait for; 0: there is none. */
  private long openLead;

  /** Makes a command of a drive. */
  @FunctionalInterface
  interface DriveCommand {
    /**
     * @param drive number of the drive that it begins or changes
     */
    Command of(long number, long drive);
  }

  private static final class Entry {
    private final long id;
    private final boolean isBegin;
    private final DriveCommand command;
    private long drive;
    private boolean isStored;

    private Entry(long id, boolean isBegin, long drive, DriveCommand command, boolean isStored) {
      this.id = id;
      this.isBegin = isBegin;
      this.drive = drive;
      this.command = command;
      this.isStored = isStored;
    }
  }

  /**
   * @param link is given each command when its turn comes
   */
  CommandQueue(Consumer<Command> link) {
    this.link = link;
  }

  /** Whether there is what must be stored before it is sent. */
  boolean isWaiting() {
    return !waiting.isEmpty();
  }

  /** The number of a drive that begins, or of a command whose number its sender must know. */
  long nextNumber() {
    return ++lastNumber;
  }

  /** Numbers go on above this one. */
  void raiseNumber(long number) {
    lastNumber = Math.max(lastNumber, number);
  }

  /** Pings at once, with a number that does not overtake a drive that is being stored. */
  void ping() {
    boolean isDriveWaiting = waiting.stream().anyMatch(entry -> entry.isBegin);
    send(new ServerMessage.Ping(isDriveWaiting ? lastSent : nextNumber()));
  }

  /** Sends it at once. */
  void send(LongFunction<Command> command) {
    send(command.apply(nextNumber()));
  }

  /**
   * Sends it at once.
   *
   * @param command with a number of {@link #nextNumber}
   */
  void send(Command command) {
    lastSent = Math.max(lastSent, command.seq());
    if (command instanceof ServerMessage.Lead) {
      openLead = command.seq();
    }
    link.accept(command);
  }

  /**
   * Sends what begins a drive once it is stored and nothing is before it.
   *
   * @param drive of {@link #nextNumber}
   * @return for {@link #setStored}
   */
  long addBegin(long drive, DriveCommand command) {
    return add(true, drive, command, false);
  }

  /** Sends a change of a drive once it is stored and nothing is before it, as a begin. */
  long addChange(long drive, DriveCommand command) {
    return add(false, drive, command, false);
  }

  /** Sends a command that need not be stored, when nothing is before it. */
  void sendInOrder(long drive, DriveCommand command) {
    if (waiting.isEmpty()) {
      send(number -> command.of(number, drive));
    } else {
      add(false, drive, command, true);
    }
  }

  private long add(boolean isBegin, long drive, DriveCommand command, boolean isStored) {
    waiting.addLast(new Entry(++lastId, isBegin, drive, command, isStored));
    return lastId;
  }

  /** What is not there any more was dropped meanwhile. */
  void setStored(long id) {
    waiting.stream().filter(entry -> entry.id == id).forEach(entry -> entry.isStored = true);
  }

  /**
   * Sends what is stored, in order.
   *
   * @return a drive whose turn it is and that was overtaken: it is to be renumbered or dropped
   */
  OptionalLong sendStored() {
    while (isHeadStored()) {
      Entry head = waiting.getFirst();
      if (head.isBegin && head.drive <= lastSent) {
        return OptionalLong.of(head.drive);
      }
      waiting.removeFirst();
      send(head.command.of(head.isBegin ? head.drive : nextNumber(), head.drive));
    }
    return OptionalLong.empty();
  }

  private boolean isHeadStored() {
    @Nullable Entry head = waiting.peekFirst();
    return head != null && head.isStored && openLead == 0;
  }

  /** The robot has taken the command of that number; {@link #sendStored} sends what waited. */
  void leadTaken(long number) {
    if (openLead == number) {
      openLead = 0;
    }
  }

  /** The robot has refused the command of that number: what waits for it is dropped. */
  void withdrawLed(long number) {
    if (openLead == number) {
      var _ = clear();
    }
  }

  /**
   * Gives a drive, whose turn it is, another number, under which it is to be stored.
   *
   * @return for {@link #setStored}
   */
  long renumberFirst(long next) {
    Entry head = waiting.getFirst();
    long previous = head.drive;
    waiting.stream().filter(entry -> entry.drive == previous).forEach(entry -> entry.drive = next);
    head.isStored = false;
    return head.id;
  }

  /** Drops what can never be stored, with all that waits for the same drive. */
  void dropNotStored(long id) {
    waiting.stream()
        .filter(entry -> entry.id == id)
        .findFirst()
        .ifPresent(entry -> drop(entry.drive));
  }

  /** Drops the drive, which nobody wants any more, with its changes. */
  void drop(long drive) {
    waiting.removeIf(entry -> entry.drive == drive);
  }

  /**
   * Drops all that waits.
   *
   * @return the last drive that was to begin
   */
  Optional<Long> clear() {
    Optional<Long> begun =
        waiting.stream()
            .filter(entry -> entry.isBegin)
            .map(entry -> entry.drive)
            .reduce((first, next) -> next);
    waiting.clear();
    openLead = 0;
    return begun;
  }
}
