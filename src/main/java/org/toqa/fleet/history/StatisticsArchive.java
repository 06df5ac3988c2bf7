package org.toqa.fleet.history;

import org.jspecify.annotations.Nullable;

/** Past work in numbers. Any thread may call it and may have to wait. */
public interface StatisticsArchive {

  /**
   * What happened in the period on all floors.
   *
   * @throws org.toqa.persistence.StoreException when the store does not answer
   */
  default PeriodStatistics statistics(Period period) {
    return statistics(period, null);
  }

  /**
   * What happened in the period. Of robots that counts which are on the floor now.
   *
   * @param floor null: on all floors
   * @throws org.toqa.persistence.StoreException when the store does not answer
   */
  PeriodStatistics statistics(Period period, @Nullable String floor);
}
