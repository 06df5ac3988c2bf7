package org.toqa.link.http;

/** Is told how the exchanges with a robot go, one call at a time; it does not wait. */
public interface ExchangeListener {
  /**
   * @param nanos from the order to its answer
   */
  void answered(long nanos);

  /** There was no answer, or none that makes sense. */
  void failed(HttpRobotException why);
}
