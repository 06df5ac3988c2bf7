package org.toqa.sim;

/** Something that lives in a simulated world and by its clock alone. */
public interface Participant {

  /**
   * @param nanos the world's time, monotonic from the clock's start
   */
  void tick(long nanos);

  /**
   * Whether the world's time may go on. One that waits for something which takes real time, such as
   * an answer of a server in this process, may hold it up.
   *
   * @param nanos the world's time
   */
  default boolean isReady(long nanos) {
    return true;
  }
}
