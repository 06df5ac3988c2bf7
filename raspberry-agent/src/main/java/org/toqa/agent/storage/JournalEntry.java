package org.toqa.agent.storage;

import com.fasterxml.jackson.annotation.JsonProperty;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.link.message.AgentMessage.ActEnd;
import org.toqa.link.message.AgentMessage.PhaseEnd;
import org.toqa.link.message.ServerMessage.Act;

/**
 * What a daemon must know again when it is started anew.
 *
 * @param powerCycle the number of the body's power-up when this was written
 * @param anchor the map pose of the origin of the body's odometry; null when it is not known
 * @param lastSeq the highest sequence number accepted so far of a command that has an effect
 * @param phase 0 to 3
 * @param load kilograms on board
 * @param drive the sequence number of the current drive, 0 for none
 * @param segment how many of its segments are completed
 * @param held whether an operator's hold is in force
 * @param done the last phase that was driven to its end and is not acknowledged yet
 * @param act what the arm was told last and has not come to an end with; null: nothing
 * @param acted how the last act ended that is not acknowledged yet
 */
public record JournalEntry(
    @JsonProperty("powerCycle") long powerCycle,
    @JsonProperty("anchor") @Nullable Pose anchor,
    @JsonProperty("lastSeq") long lastSeq,
    @JsonProperty("task") @Nullable Long task,
    @JsonProperty("phase") int phase,
    @JsonProperty("load") double load,
    @JsonProperty("drive") long drive,
    @JsonProperty("segment") int segment,
    @JsonProperty("held") boolean held,
    @JsonProperty("done") @Nullable PhaseEnd done,
    @JsonProperty("act") @Nullable Act act,
    @JsonProperty("acted") @Nullable ActEnd acted) {

  public static JournalEntry of(long powerCycle, @Nullable Pose anchor) {
    return new JournalEntry(powerCycle, anchor, 0, null, 0, 0, 0, 0, false, null, null, null);
  }

  public JournalEntry withLastSeq(long seq) {
    return new JournalEntry(
        powerCycle, anchor, seq, task, phase, load, drive, segment, held, done, act, acted);
  }

  public JournalEntry withAnchor(long cycle, @Nullable Pose origin) {
    return new JournalEntry(
        cycle, origin, lastSeq, task, phase, load, drive, segment, held, done, act, acted);
  }

  /**
   * A new drive; it shows that the server knows of the last one's end.
   *
   * @param newDrive its sequence number
   * @param inPhase 0 to 3
   * @param onBoard kilograms
   */
  public JournalEntry withDrive(long newDrive, @Nullable Long ofTask, int inPhase, double onBoard) {
    return new JournalEntry(
        powerCycle, anchor, lastSeq, ofTask, inPhase, onBoard, newDrive, 0, held, null, null, null);
  }

  public JournalEntry withSegment(int completed) {
    return new JournalEntry(
        powerCycle, anchor, lastSeq, task, phase, load, drive, completed, held, done, act, acted);
  }

  public JournalEntry withHold(boolean hold) {
    return new JournalEntry(
        powerCycle, anchor, lastSeq, task, phase, load, drive, segment, hold, done, act, acted);
  }

  /** The drive is at its end, and with it the phase. */
  public JournalEntry withPhaseEnd() {
    return new JournalEntry(
        powerCycle,
        anchor,
        lastSeq,
        task,
        phase,
        load,
        0,
        0,
        held,
        new PhaseEnd(task, phase, drive),
        act,
        acted);
  }

  /** The drive is no more, but its task and phase are still what the robot works for. */
  public JournalEntry withoutDrive() {
    return new JournalEntry(
        powerCycle, anchor, lastSeq, task, phase, load, 0, 0, held, done, act, acted);
  }

  /** The robot works for nothing any more. */
  public JournalEntry withoutTask() {
    return new JournalEntry(powerCycle, anchor, lastSeq, null, 0, 0, 0, 0, held, null, null, null);
  }

  public JournalEntry withoutDone() {
    return new JournalEntry(
        powerCycle, anchor, lastSeq, task, phase, load, drive, segment, held, null, act, acted);
  }

  /** The arm begins an action; the robot works for its task. */
  public JournalEntry withAct(Act order) {
    return new JournalEntry(
        powerCycle,
        anchor,
        lastSeq,
        order.task(),
        order.phase(),
        load,
        drive,
        segment,
        held,
        done,
        order,
        null);
  }

  /** What the arm did has ended so. */
  public JournalEntry withActEnd(ActEnd end) {
    return new JournalEntry(
        powerCycle, anchor, lastSeq, task, phase, load, drive, segment, held, done, null, end);
  }

  public JournalEntry withoutActed() {
    return new JournalEntry(
        powerCycle, anchor, lastSeq, task, phase, load, drive, segment, held, done, act, null);
  }
}
