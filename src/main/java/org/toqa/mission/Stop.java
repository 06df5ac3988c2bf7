package org.toqa.mission;

import java.time.Duration;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * A place on a mission's way, with what its robots wait for there before they drive on: whichever
 * of it comes first.
 *
 * @param place where it is; of a charging point that the robot chooses one that it may be
 * @param awaitsPerson whether they wait until a person says that they may go on
 * @param waitTime how long they wait after they have come; null: as long as else is waited for
 * @param charge how the robot charges there; null: it is no charging point
 */
public record Stop(
    TaskPlace place, boolean awaitsPerson, @Nullable Duration waitTime, @Nullable Charge charge) {

  /**
   * What is ordered of charging.
   *
   * @param charger the charging point's name; null: one that the robot chooses
   * @param until as far as this, of 0 to 1; null: nobody said
   */
  public record Charge(@Nullable String charger, @Nullable Double until) {

    /** For people: the charging point. */
    public Sentence sentence() {
      return charger == null
          ? Phrase.CHARGER_OF_ITS_CHOICE.with()
          : Phrase.CHARGER_NAMED.with(charger);
    }
  }

  /** One that is no charging point. */
  public Stop(TaskPlace place, boolean awaitsPerson, @Nullable Duration waitTime) {
    this(place, awaitsPerson, waitTime, null);
  }

  /** One at which nobody waits. */
  public static Stop at(TaskPlace place) {
    return new Stop(place, false, null);
  }

  /** For people: where it is. */
  public Sentence sentence() {
    return charge == null ? place.sentence() : charge.sentence();
  }

  /**
   * How long they still wait here, 0 or less where that is over; empty: no time was said.
   *
   * @param waited for how long they have, both of the fleet's time
   */
  public Optional<Duration> waitLeft(Duration waited) {
    return Optional.ofNullable(waitTime).map(wait -> wait.minus(waited));
  }

  /** Whether nothing else lets the robots drive on than a person. */
  public boolean awaitsPersonAlone() {
    return awaitsPerson && waitTime == null && (charge == null || charge.until() == null);
  }

  public boolean hasWait() {
    return awaitsPerson || waitTime != null || charge != null;
  }

  /**
   * As far as the robot charges here, of 0 to 1; empty: that does not let it go on.
   *
   * @param usual as far as robots charge otherwise, which counts where nothing else is waited for
   */
  public Optional<Double> chargesUntil(double usual) {
    if (charge == null) {
      return Optional.empty();
    }
    boolean isOpen = charge.until() == null && !awaitsPerson && waitTime == null;
    return isOpen ? Optional.of(usual) : Optional.ofNullable(charge.until());
  }
}
