package org.toqa.web.access;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.accounts.Power;

/** Who may use a route. */
public enum Permission {
  /** Everybody, also who is not signed in. */
  ANONYMOUS(null, "problem.login"),
  /** Everybody who is signed in, whatever the account's role. */
  SIGNED_IN(null, "problem.login"),
  VIEW(Power.VIEW, "problem.managersOnly"),
  ORDER(Power.ORDER, "problem.viewersLook"),
  PAUSE(Power.PAUSE, "problem.viewersLook"),
  OPERATE(Power.OPERATE, "problem.operatorsOnly"),
  MANAGE(Power.MANAGE, "problem.managersOnly"),
  ADMINISTER(Power.ADMINISTER, "problem.administratorsOnly");

  private final @Nullable Power power;
  private final String refusalKey;

  /**
   * @param power that a user's role must have; null: none
   * @param refusalKey of the sentence for a user who does not have it
   */
  Permission(@Nullable Power power, String refusalKey) {
    this.power = power;
    this.refusalKey = refusalKey;
  }

  /** What a user's role must have; empty: nothing. */
  Optional<Power> power() {
    return Optional.ofNullable(power);
  }

  public String refusalKey() {
    return refusalKey;
  }
}
