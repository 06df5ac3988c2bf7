package org.toqa.fleet.floor;

import java.time.Duration;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.ChargeRecord;
import org.toqa.fleet.ChargeRecord.Turn;
import org.toqa.wording.Sentence;

/** The state of a robot's charging. Only {@link ChargingDispatcher} changes it. */
final class ChargingState {
  private Duration workedSinceCharge = Duration.ZERO;
  private Duration storedWork = Duration.ZERO;
  private @Nullable Turn turn;
  private boolean turnStored;
  private boolean charging;
  private boolean begun;
  private boolean awaitingTurn;
  private boolean helpNeeded;
  private @Nullable Sentence status;
  private @Nullable Long taskBeyondBattery;
  private boolean forTask;

  /** Its place at a charging point; empty: it need not charge. */
  Optional<Turn> turn() {
    return Optional.ofNullable(turn);
  }

  boolean hasTurn() {
    return turn != null;
  }

  /** Whether the turn is safe, so that the robot may move for it. */
  boolean isTurnStored() {
    return turnStored;
  }

  /** Whether it is at its charging point and is the first one there. */
  boolean isCharging() {
    return charging;
  }

  /** Whether it has charged in this turn, though it may have made room for another since. */
  boolean hasBegun() {
    return begun;
  }

  /** Whether others come before it at its charging point. */
  boolean isAwaitingTurn() {
    return awaitingTurn;
  }

  /** Whether it charges since its task says so. */
  boolean isForTask() {
    return forTask;
  }

  /** Why a person must help, for it may not reach a charging point; null: nobody must. */
  @Nullable Sentence alert() {
    return helpNeeded ? status : null;
  }

  /** What it does about charging; null: nothing. */
  @Nullable Sentence status() {
    return status;
  }

  /** How long it has worked since it last charged. */
  Duration workedSinceCharge() {
    return workedSinceCharge;
  }

  /** A task that it was free for, but its battery would not have lasted; null: there is none. */
  @Nullable Long taskBeyondBattery() {
    return taskBeyondBattery;
  }

  /** What is to be stored of it. */
  ChargeRecord record(String robot) {
    return new ChargeRecord(robot, workedSinceCharge, turn);
  }

  /** Goes on with what was stored before a restart. */
  void recover(ChargeRecord record) {
    workedSinceCharge = record.worked();
    storedWork = record.worked();
    turn = record.turn();
    turnStored = true;
  }

  /**
   * @return whether so much has come together since it was stored that it shall be stored again;
   *     that is taken as done
   */
  boolean addWork(Duration passed, Duration storedEvery) {
    workedSinceCharge = workedSinceCharge.plus(passed);
    if (workedSinceCharge.minus(storedWork).compareTo(storedEvery) < 0) {
      return false;
    }
    storedWork = workedSinceCharge;
    return true;
  }

  void setTaskBeyondBattery(long task) {
    taskBeyondBattery = task;
  }

  /** It may not move for the turn until that is stored. */
  void takeTurn(Turn next) {
    turn = next;
    turnStored = false;
    begun = false;
    taskBeyondBattery = null;
  }

  /**
   * @param stored null: that it has none
   */
  void confirmStored(@Nullable Turn stored) {
    turnStored |= Objects.equals(turn, stored);
  }

  void setForTask(boolean ordered) {
    forTask = ordered;
  }

  void setCharging(boolean charges) {
    charging = charges;
    begun |= charges;
  }

  void setAwaitingTurn(boolean waits) {
    awaitingTurn = waits;
  }

  /** It is charged: its work counts from now. */
  void resetWork() {
    workedSinceCharge = Duration.ZERO;
    storedWork = Duration.ZERO;
  }

  void endTurn() {
    turn = null;
    turnStored = false;
    charging = false;
    begun = false;
    awaitingTurn = false;
    helpNeeded = false;
    status = null;
    forTask = false;
  }

  /**
   * @param needsHelp whether a person must help
   * @return whether that is new
   */
  boolean setStatus(@Nullable Sentence sentence, boolean needsHelp) {
    boolean isNew = !Objects.equals(status, sentence);
    status = sentence;
    helpNeeded = needsHelp;
    return isNew;
  }
}
