package org.toqa.agent.firmware;

import java.io.IOException;

/** Carries frames to a microcontroller and back; it does not look into them. One thread uses it. */
public interface FrameTransport extends AutoCloseable {

  /**
   * Sends a frame and receives one, at the same time or soon after.
   *
   * @param frame of {@link FrameCodec#LENGTH} bytes
   * @param nanos the daemon's monotonic time; simulated hardware simulates up to it
   * @return as many bytes, good or not; none where nothing came
   */
  byte[] exchange(byte[] frame, long nanos) throws IOException;

  /**
   * Tells hardware that is simulated what its arm will grasp.
   *
   * @param kilograms 0 or more
   */
  default void expectLoad(double kilograms) {}

  @Override
  void close();
}
