package org.toqa.fleet.history;

/** Past work in numbers. Any thread may call it and may have to wait. */
public interface StatisticsArchive {

  /**
   * What happened in the period.
   *
   * @throws org.toqa.persistence.StoreException when the store does not answer
   */
  PeriodStatistics statistics(Period period);
}
