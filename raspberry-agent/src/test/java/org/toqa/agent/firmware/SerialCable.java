package org.toqa.agent.firmware;

import static org.junit.jupiter.api.Assertions.assertNotNull;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.UnaryOperator;

/**
 * A serial port with a microcontroller at its other end, by a pseudo-terminal that {@code socat}
 * makes: plugged in while it lives. What the microcontroller hears is kept, and answered.
 */
final class SerialCable implements AutoCloseable {

  private static final int LIMIT_SECONDS = 10;

  private final Process socat;
  private final BlockingQueue<byte[]> heard = new LinkedBlockingQueue<>();

  /**
   * @param device where the port is to be found
   * @param firmware what is sent back for a frame
   */
  static SerialCable plugIn(Path device, UnaryOperator<byte[]> firmware) throws IOException {
    Process socat =
        new ProcessBuilder("socat", "-d", "-d", "-", "PTY,raw,echo=0,link=" + device).start();
    BufferedReader log = socat.errorReader();
    String line = log.readLine();
    while (line != null && !line.contains("starting data transfer")) {
      line = log.readLine();
    }
    assertNotNull(line, "socat ended");
    return new SerialCable(socat, firmware);
  }

  private SerialCable(Process socat, UnaryOperator<byte[]> firmware) {
    this.socat = socat;
    Thread.ofPlatform()
        .daemon()
        .start(() -> answerFrames(firmware)); // reading a pipe holds its carrier
  }

  /** The next frame that arrived at the microcontroller. */
  byte[] heard() throws InterruptedException {
    byte[] frame = heard.poll(LIMIT_SECONDS, TimeUnit.SECONDS);
    assertNotNull(frame, "nothing arrived");
    return frame;
  }

  @Override
  public void close() {
    socat.destroy();
    socat.onExit().orTimeout(LIMIT_SECONDS, TimeUnit.SECONDS).join();
  }

  private void answerFrames(UnaryOperator<byte[]> firmware) {
    try (InputStream in = socat.getInputStream();
        OutputStream out = socat.getOutputStream()) {
      byte[] frame = in.readNBytes(FrameCodec.LENGTH);
      while (frame.length == FrameCodec.LENGTH) {
        heard.add(frame);
        out.write(firmware.apply(frame));
        out.flush();
        frame = in.readNBytes(FrameCodec.LENGTH);
      }
    } catch (IOException e) {
      // the cable was pulled
    }
  }
}
