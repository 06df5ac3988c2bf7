package org.toqa.agent.formation;

import org.toqa.agent.chassis.Chassis;

/**
 * At which ticks a leader broadcasts. Ticks are late by more or less; the one nearest to the time
 * is meant, else the messages would come now a tick early and now a tick late.
 */
public final class BroadcastTimer {

  public static final long PERIOD_NANOS = 200_000_000;

  /** While the leader brakes, at every tick: what followers do not know yet strains the shape. */
  private static final long BRAKING_PERIOD_NANOS = Chassis.TICK.toNanos();

  private static final long HALF_A_TICK = Chassis.TICK.toNanos() / 2;

  private long due;

  /**
   * @param nanos when it broadcasts first
   */
  BroadcastTimer(long nanos) {
    due = nanos;
  }

  /**
   * To be asked at every tick.
   *
   * @param braking whether the leader stops for a follower's sake and still moves
   * @return whether it broadcasts at this one
   */
  boolean fireIfDue(boolean braking, long nanos) {
    long time = braking ? due - PERIOD_NANOS + BRAKING_PERIOD_NANOS : due;
    if (nanos < time - HALF_A_TICK) {
      return false;
    }
    due = braking || nanos - due > PERIOD_NANOS ? nanos + PERIOD_NANOS : due + PERIOD_NANOS;
    return true;
  }
}
