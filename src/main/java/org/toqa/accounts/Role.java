package org.toqa.accounts;

import static org.toqa.accounts.Power.ADMINISTER;
import static org.toqa.accounts.Power.MANAGE;
import static org.toqa.accounts.Power.OPERATE;
import static org.toqa.accounts.Power.ORDER;
import static org.toqa.accounts.Power.PAUSE;
import static org.toqa.accounts.Power.VIEW;

import java.util.Set;

/** What a user is, by what he may do; in the order in which pages offer them. */
public enum Role {
  /** Sees everything, and changes nothing. */
  VIEWER(VIEW),
  /** Adds tasks and changes his own. */
  CLERK(VIEW, ORDER, PAUSE),
  /** Keeps the robots and everybody's tasks going. */
  OPERATOR(VIEW, ORDER, PAUSE, OPERATE),
  /** May do everything within the site. */
  MANAGER(VIEW, ORDER, PAUSE, OPERATE, MANAGE),
  /** A manager of the first site who also makes other sites, and sees them all. */
  ADMINISTRATOR(VIEW, ORDER, PAUSE, OPERATE, MANAGE, ADMINISTER);

  @SuppressWarnings("ImmutableEnumChecker") // a copy that cannot be changed
  private final Set<Power> powers;

  Role(Power... powers) {
    this.powers = Set.of(powers);
  }

  public boolean has(Power power) {
    return powers.contains(power);
  }

  public boolean isManager() {
    return has(MANAGE);
  }
}
