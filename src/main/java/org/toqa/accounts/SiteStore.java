package org.toqa.accounts;

import java.util.List;
import java.util.Optional;

/**
 * The sites of a server, which its first site keeps. A site is first reserved and then complete:
 * one whose making was cut short is none. What is done is told in the first site's history.
 *
 * <p>Any thread may call it and may have to wait. Every method throws {@link
 * org.toqa.persistence.StoreException} when the store does not answer.
 */
public interface SiteStore {
  /** All that are complete, the first one first. */
  List<Site> sites();

  /**
   * Takes the name, and an id that no other site had or gets.
   *
   * @return empty when the name is taken
   */
  Optional<Site> reserve(String name);

  /**
   * From now on it is one of the sites.
   *
   * @param by who made it
   */
  void complete(Site site, String by);

  /** Gives back the names of all that are reserved only. */
  void discardReserved();

  /**
   * Removes it from the list. What it has stored stays where it is, and no later site finds it.
   *
   * @param by who does it
   * @throws IllegalArgumentException it is the first one
   */
  void remove(Site site, String by);
}
