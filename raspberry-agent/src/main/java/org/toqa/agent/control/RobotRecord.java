package org.toqa.agent.control;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.agent.chassis.ChassisReading;
import org.toqa.agent.storage.Journal;
import org.toqa.agent.storage.JournalEntry;
import org.toqa.geometry.Pose;
import org.toqa.link.message.AgentMessage.ActEnd;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.AgentMessage.PhaseEnd;
import org.toqa.link.message.ServerMessage.Act;
import org.toqa.link.message.ServerMessage.Cancel;
import org.toqa.link.message.ServerMessage.Clear;
import org.toqa.link.message.ServerMessage.Command;
import org.toqa.link.message.ServerMessage.Drive;
import org.toqa.link.message.ServerMessage.Extend;
import org.toqa.link.message.ServerMessage.Follow;
import org.toqa.link.message.ServerMessage.Hold;
import org.toqa.link.message.ServerMessage.Lead;
import org.toqa.link.message.ServerMessage.Locate;
import org.toqa.link.message.ServerMessage.Ping;
import org.toqa.link.message.ServerMessage.Release;
import org.toqa.link.message.ServerMessage.Resume;
import org.toqa.link.message.ServerMessage.Room;

/**
 * What a robot knows of itself: the journal, which outlives the daemon, and the last reading of its
 * body, which together say where it is. For the thread of the ticks.
 */
final class RobotRecord {

  private static final Logger log = LoggerFactory.getLogger(RobotRecord.class);
  private static final Pose ORIGIN = new Pose(0, 0, 0);

  private final String name;
  private final Journal journal;
  private ChassisReading reading;
  private @Nullable Fault restartFault;

  /** What anchor and odometry make; null after one of them has changed. */
  private @Nullable Pose pose;

  /**
   * Recovers what an earlier daemon recorded.
   *
   * @param name of the robot
   * @throws IOException if the journal cannot be written
   */
  RobotRecord(String name, Journal journal, ChassisReading reading) throws IOException {
    this.name = name;
    this.journal = journal;
    this.reading = reading;
    if (!journal.saveDurably(recoverEntry())) {
      throw new IOException(journal.fault().orElseThrow().text());
    }
  }

  private JournalEntry recoverEntry() {
    if (journal.entry().isEmpty()) {
      return JournalEntry.of(reading.powerCycle(), reading.startPose());
    }
    JournalEntry old = entry();
    if (old.drive() != 0) {
      restartFault =
          new Fault(
              "RESTARTED",
              "The daemon was restarted during drive %d, after %d of its segments; it waits for a new drive."
                  .formatted(old.drive(), old.segment()));
      log.warn("{}: {}", name, restartFault.text());
    }
    if (old.act() != null) {
      restartFault =
          new Fault(
              "RESTARTED",
              "The daemon was restarted while the arm did act %d; it waits for the act to be told anew."
                  .formatted(old.act().seq()));
      log.warn("{}: {}", name, restartFault.text());
    }
    return old.withoutDrive()
        .withAnchor(
            reading.powerCycle(),
            old.powerCycle() == reading.powerCycle() ? old.anchor() : reading.startPose());
  }

  /**
   * Takes the reading of a tick.
   *
   * @return whether what the robot did is over: the body was powered up anew since the last one, or
   *     a stop of its own is over, after which nothing moves by itself
   */
  boolean update(ChassisReading newReading) {
    boolean isNewPowerCycle = newReading.powerCycle() != reading.powerCycle();
    boolean isStopOver = reading.hasOwnStop() && !newReading.hasOwnStop();
    if (isNewPowerCycle) {
      log.warn("{}: the body was powered up anew.", logName());
      journal.saveDurably(
          entry().withoutDrive().withAnchor(newReading.powerCycle(), newReading.startPose()));
    } else if (isStopOver) {
      log.info(
          "{}: {} over; it waits for a new drive.",
          logName(),
          reading.faults().stream().map(Fault::code).toList());
      journal.saveDurably(entry().withoutDrive());
    }
    reading = newReading;
    pose = null;
    return isNewPowerCycle || isStopOver;
  }

  JournalEntry entry() {
    return journal.entry().orElseThrow();
  }

  ChassisReading reading() {
    return reading;
  }

  boolean isLocalised() {
    return anchor() != null;
  }

  /** The map's pose of the origin of the body's odometry; null where it is not known. */
  @Nullable Pose anchor() {
    return entry().powerCycle() == reading.powerCycle() ? entry().anchor() : null;
  }

  /** Map frame; an arbitrary frame while the robot is not localised. */
  Pose pose() {
    if (pose == null) {
      Pose anchor = anchor();
      pose = anchor == null ? reading.odometry() : anchor.compose(reading.odometry());
    }
    return pose;
  }

  /** The name of the robot, and its task if it has one. */
  String logName() {
    return entry().task() == null ? name : name + " task " + entry().task();
  }

  /** What is wrong with the body, with the last start and with the journal, in this order. */
  List<Fault> faults() {
    List<Fault> faults = new ArrayList<>(reading.faults());
    if (restartFault != null) {
      faults.add(restartFault);
    }
    journal.fault().ifPresent(faults::add);
    return faults;
  }

  /**
   * Records what a command that is accepted changes.
   *
   * @return false: the journal could not be written, and nothing is changed
   */
  boolean saveAccepted(Command command) {
    JournalEntry next = entryAfter(command).withLastSeq(command.seq());
    boolean isSaved =
        switch (command) {
          case Extend _, Release _, Room _ ->
              journal.save(next); // it drives, and must not wait for the disk
          default -> journal.saveDurably(next);
        };
    pose = null;
    if (isSaved && endsWaitAfterRestart(command)) {
      restartFault = null;
    }
    return isSaved;
  }

  private JournalEntry entryAfter(Command command) {
    return switch (command) {
      case Drive drive -> entry().withDrive(drive.seq(), drive.task(), drive.phase(), drive.load());
      case Follow follow -> entry().withDrive(follow.seq(), follow.task(), 2, share(follow));
      case Act act -> entry().withAct(act);
      case Hold _ -> entry().withHold(true);
      case Resume _ -> entry().withHold(false);
      case Cancel cancel ->
          Objects.equals(cancel.task(), entry().task()) ? entry().withoutTask() : entry();
      case Locate locate ->
          // anchor * odometry = pose
          entry()
              .withAnchor(
                  reading.powerCycle(), locate.pose().compose(reading.odometry().relative(ORIGIN)));
      case Extend _, Release _, Room _, Lead _, Clear _, Ping _ -> entry();
    };
  }

  private static double share(Follow follow) {
    return follow.carries() == null ? 0 : follow.carries().share();
  }

  private boolean endsWaitAfterRestart(Command command) {
    return switch (command) {
      case Drive _, Follow _, Act _ -> true;
      case Cancel _ -> entry().task() == null;
      default -> false;
    };
  }

  /** Records how many segments of the drive are completed. */
  void saveSegment(int completed) {
    if (completed != entry().segment()) {
      journal.save(entry().withSegment(completed));
    }
  }

  /**
   * Records that the phase is driven to its end.
   *
   * @return false: the journal could not be written, and the phase goes on
   */
  boolean savePhaseEnd() {
    return journal.saveDurably(entry().withPhaseEnd());
  }

  /**
   * Records how what the arm did ended.
   *
   * @return false: the journal could not be written
   */
  boolean saveActEnd(ActEnd end) {
    return journal.saveDurably(entry().withActEnd(end));
  }

  /**
   * Records that the server has stored the end of an act.
   *
   * @param act its sequence number
   */
  void acknowledgeActed(long act) {
    ActEnd acted = entry().acted();
    if (acted != null && acted.act() == act) {
      journal.saveDurably(entry().withoutActed());
    }
  }

  /**
   * Records that the server has stored the end of a drive.
   *
   * @param drive its sequence number
   */
  void acknowledgeDone(long drive) {
    PhaseEnd done = entry().done();
    if (done == null || done.drive() != drive) {
      return;
    }
    boolean isTaskOver = done.phase() == 3 && entry().drive() == 0;
    journal.saveDurably(isTaskOver ? entry().withoutTask() : entry().withoutDone());
  }
}
