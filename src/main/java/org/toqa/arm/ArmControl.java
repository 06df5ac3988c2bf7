package org.toqa.arm;

import java.util.ArrayDeque;
import java.util.Comparator;
import java.util.Deque;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * Moves an arm through the steps of an action.
 *
 * <ol>
 *   <li>{@link #begin} takes an action whose place was found to be in reach.
 *   <li>{@link #advance} is called at every tick, and says what to command. Where the arm may not
 *       move it slows down at once and stands; when it may again, it goes on with the same step.
 *   <li>{@link #takeOutcome} has how the action ended, once. What went wrong is told after the arm
 *       has come back to its rest, but for joints that do not follow: they stand.
 *   <li>{@link #cancel} ends an action without an outcome: the arm stands where it is.
 *   <li>{@link #fold} brings an arm that does nothing else to its rest. One that does not come
 *       there stands ({@link #hasFailedToFold}) until {@link #cancel}: something may hold it.
 * </ol>
 *
 * <p>An arm that does nothing and is pushed aside stands where it was left.
 *
 * <p>Time is handed in. For one thread.
 */
public final class ArmControl {

  /** Seconds that a hand needs to close or open. */
  static final double HAND_SECONDS = 0.6;

  /** Seconds over which the load sensor's readings are averaged. */
  static final double WEIGHING_SECONDS = 0.5;

  /** Radians; a joint that is so near is where it shall be. */
  static final double TOLERANCE = 0.01;

  /**
   * Radians; a joint that is so near to its rest is there. Where servo and potentiometer differ by
   * more than 0.03, a microcontroller tells by how much.
   */
  static final double REST_TOLERANCE = 0.05;

  /** Radians that a joint may be behind while it turns, beside what it turns in {@link #DELAY}. */
  static final double MOST_BEHIND = 0.2;

  /** Seconds until an arm that finds its own way obeys, and is known to. */
  static final double DELAY = 0.1;

  /** Seconds that it may be so. */
  static final double STALLED_SECONDS = 1.5;

  private final Arm arm;
  private final JointMotion motion;
  private final Deque<ArmStep> steps = new ArrayDeque<>();
  private ArmReading reading;
  private boolean handClosed;
  private JointAngles place = JointAngles.ZERO;
  private boolean isFolding;
  private boolean hasFailedToFold;
  private double stepSeconds;
  private double stalledSeconds;
  private double weightSum;
  private int weightCount;
  private @Nullable Double weight;
  private @Nullable ArmFailure failure;
  private @Nullable ArmOutcome outcome;

  public ArmControl(Arm arm, ArmReading reading) {
    this.arm = arm;
    this.reading = reading;
    this.motion = new JointMotion(arm, reading.angles());
    this.handClosed = reading.handClosed();
  }

  /**
   * Begins an action in the place of whatever it did.
   *
   * @param joints how the joints stand when the hand is at the place
   * @param isRepeated whether the same action was begun before and did not come to its end, so that
   *     the load may be in the hand already, or out of it
   */
  public void begin(ArmAction action, JointAngles joints, boolean isRepeated) {
    cancel();
    place = joints;
    boolean isHolding = reading.isHolding();
    boolean isPick = action == ArmAction.PICK;
    if (isHolding == isPick && !isRepeated) {
      outcome = new ArmOutcome(isPick ? ArmFailure.HAND_FULL : ArmFailure.NOTHING_HELD, null);
      return;
    }
    steps.addAll(action.steps());
    if (isHolding == isPick) { // it had the load in hand, or had let it go
      while (steps.peek() == ArmStep.REACH
          || steps.peek() == ArmStep.GRASP
          || steps.peek() == ArmStep.RELEASE) {
        steps.remove();
      }
    }
    beginStep();
  }

  /** Of two ways to the same place, the one that it is at sooner. */
  public JointAngles nearest(Reach.Within reach) {
    return reach.ways().stream()
        .min(
            Comparator.comparingDouble(
                way -> JointTrajectory.between(arm, motion.now().angles(), way).duration()))
        .orElseThrow();
  }

  private void beginStep() {
    stepSeconds = 0;
    switch (steps.peek()) {
      case REACH -> motion.setGoal(place);
      case FOLD -> motion.setGoal(arm.rest());
      case GRASP -> handClosed = true;
      case RELEASE -> handClosed = false;
      case WEIGH -> {
        weightSum = 0;
        weightCount = 0;
      }
      case null -> {
        outcome = new ArmOutcome(failure, weight);
        failure = null;
        weight = null;
      }
    }
  }

  /** Stops what it does; the hand stays as it is. */
  public void cancel() {
    steps.clear();
    failure = null;
    weight = null;
    outcome = null;
    isFolding = false;
    hasFailedToFold = false;
    stalledSeconds = 0;
    motion.setGoal(motion.now().angles());
  }

  /** Brings it to its rest, if it does nothing else and has not failed to. */
  public void fold() {
    if (steps.isEmpty() && !hasFailedToFold) {
      isFolding = true;
      motion.setGoal(arm.rest());
    }
  }

  /** Whether it was to come to its rest, and something kept it from that. */
  public boolean hasFailedToFold() {
    return hasFailedToFold;
  }

  /**
   * One tick.
   *
   * @param seconds since the last one
   * @param now the arm as it is
   * @param mayMove false: it is held, or its body has a fault
   */
  public ArmCommand advance(double seconds, ArmReading now, boolean mayMove) {
    reading = now;
    motion.advance(seconds, mayMove, now.angles());
    if (mayMove && !steps.isEmpty()) {
      stepSeconds += seconds;
      if (isStalled(seconds)) {
        steps.clear();
        stand();
        outcome = new ArmOutcome(ArmFailure.STALLED, weight);
      } else {
        advanceStep();
      }
    } else if (mayMove && isFolding) {
      if (isStalled(seconds)) {
        stand();
        hasFailedToFold = true;
      } else if (isFolded()) {
        isFolding = false;
      }
    } else if (steps.isEmpty() && now.stalled()) {
      stand();
    }
    JointTrajectory.Moment moment = motion.now();
    return new ArmCommand(moment.angles(), moment.rates(), handClosed, motion.goal(), mayMove);
  }

  private void stand() {
    isFolding = false;
    stalledSeconds = 0;
    motion.stand(reading.angles());
  }

  private boolean isStalled(double seconds) {
    double most =
        motion.isStanding()
            ? tolerance()
            : MOST_BEHIND + DELAY * Math.max(arm.shoulder().maxRate(), arm.elbow().maxRate());
    stalledSeconds = error() > most ? stalledSeconds + seconds : 0;
    return reading.stalled() || stalledSeconds > STALLED_SECONDS;
  }

  private double tolerance() {
    return motion.goal().equals(arm.rest()) ? REST_TOLERANCE : TOLERANCE;
  }

  private double error() {
    return reading.angles().minus(motion.now().angles()).largest();
  }

  private void advanceStep() {
    switch (steps.element()) {
      case REACH, FOLD -> {
        if (motion.isAtGoal() && error() <= tolerance()) {
          endStep();
        }
      }
      case GRASP -> {
        if (stepSeconds >= HAND_SECONDS) {
          endStep();
        }
      }
      case WEIGH -> weigh();
      case RELEASE -> {
        if (stepSeconds >= HAND_SECONDS) {
          if (reading.load() >= ArmReading.LEAST_LOAD) {
            failure = ArmFailure.NOT_RELEASED;
          }
          endStep();
        }
      }
    }
  }

  private void weigh() {
    weightSum += reading.load();
    weightCount++;
    if (stepSeconds < WEIGHING_SECONDS) {
      return;
    }
    double mean = weightSum / weightCount;
    if (mean < ArmReading.LEAST_LOAD) {
      letGo(ArmFailure.NOTHING_GRASPED);
    } else {
      weight = mean;
      if (mean > arm.maxLoad()) {
        letGo(ArmFailure.TOO_HEAVY);
      } else {
        endStep();
      }
    }
  }

  private void letGo(ArmFailure why) {
    failure = why;
    steps.clear();
    steps.add(ArmStep.RELEASE);
    steps.add(ArmStep.FOLD);
    beginStep();
  }

  private void endStep() {
    steps.remove();
    beginStep();
  }

  /** What it is at; empty: it does nothing. */
  public Optional<ArmStep> step() {
    return Optional.ofNullable(steps.peek());
  }

  /** How the last action ended, the first time that it is asked. */
  public Optional<ArmOutcome> takeOutcome() {
    ArmOutcome ended = outcome;
    outcome = null;
    return Optional.ofNullable(ended);
  }

  /** Whether it is at its rest, so that the robot may drive. */
  public boolean isFolded() {
    return reading.angles().minus(arm.rest()).largest() <= REST_TOLERANCE && motion.isStanding();
  }

  /** Whether its joints are told to stand. */
  public boolean isStanding() {
    return motion.isStanding();
  }
}
