package org.toqa.allocation;

import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** Whether a robot can be given a task now, or what keeps it. */
public enum Availability {
  /** Idle, or driving home. */
  FREE(Phrase.NEEDED_ELSEWHERE, Phrase.CANNOT_OF_SEVERAL),
  BUSY(Phrase.WORKS_ON_ANOTHER, Phrase.WORK_ON_OTHERS),
  HELD(Phrase.IS_HELD, Phrase.ARE_HELD),
  DRIVEN_BY_HAND(Phrase.IS_DRIVEN_BY_HAND, Phrase.ARE_DRIVEN_BY_HAND),
  /** At a charging point, driving to one, or waiting for one. */
  CHARGING(Phrase.CHARGES_FIRST, Phrase.CHARGE_FIRST),
  OUT_OF_SERVICE(Phrase.IS_OUT_OF_SERVICE, Phrase.ARE_OUT_OF_SERVICE),
  LOST(Phrase.IS_LOST, Phrase.ARE_LOST),
  CONNECTING(Phrase.IS_UNHEARD_YET, Phrase.ARE_UNHEARD_YET),
  NOT_LOCALISED(Phrase.IS_NOT_LOCALISED, Phrase.ARE_NOT_LOCALISED),
  ERROR(Phrase.REPORTS_ERROR, Phrase.REPORT_ERRORS);

  private final Phrase ofOne;
  private final Phrase ofSeveral;

  Availability(Phrase ofOne, Phrase ofSeveral) {
    this.ofOne = ofOne;
    this.ofSeveral = ofSeveral;
  }

  /** Follows a robot's name in a sentence. */
  Sentence ofOne() {
    return ofOne.with();
  }

  Sentence ofSeveral(long robots) {
    return ofSeveral.with(robots);
  }
}
