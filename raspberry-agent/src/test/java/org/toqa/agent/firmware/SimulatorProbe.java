package org.toqa.agent.firmware;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.Channels;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;

/** Looks at the simulated microcontroller from outside: what no robot knows of itself. */
public final class SimulatorProbe implements AutoCloseable {

  private static final Pattern PAIR = Pattern.compile("(\\w+)=(\"[^\"]*\"|\\S+)");

  private final SocketChannel channel;
  private final BufferedReader answers;

  public SimulatorProbe(Path socket) throws IOException {
    channel = SocketChannel.open(StandardProtocolFamily.UNIX);
    channel.connect(UnixDomainSocketAddress.of(socket));
    answers =
        new BufferedReader(
            new InputStreamReader(Channels.newInputStream(channel), StandardCharsets.US_ASCII));
  }

  /** All that the simulator tells, by name. */
  public Truth truth() throws IOException {
    send("Q");
    Map<String, String> values = new HashMap<>();
    for (MatchResult pair : PAIR.matcher(answers.readLine()).results().toList()) {
      values.put(pair.group(1), pair.group(2).replace("\"", ""));
    }
    return new Truth(values);
  }

  /** Changes the surroundings, such as {@code floor 2 gone}. */
  public void change(String order) throws IOException {
    send("S" + order + "\n");
    assertEquals("ok", answers.readLine());
  }

  /** Time passes, and nobody says anything over the SPI. */
  public void advance(Duration time) throws IOException {
    exchange(time, new byte[0]);
  }

  /** Time passes, in the end of which bytes are exchanged; what comes back is dropped. */
  void exchange(Duration time, byte[] bytes) throws IOException {
    ByteBuffer request =
        ByteBuffer.allocate(7 + bytes.length)
            .order(ByteOrder.LITTLE_ENDIAN)
            .put((byte) 'X')
            .putInt((int) (time.toNanos() / 1_000))
            .putShort((short) bytes.length)
            .put(bytes)
            .flip();
    channel.write(request);
    for (int i = 0; i < Math.max(1, bytes.length); i++) {
      answers.read();
    }
  }

  private void send(String text) throws IOException {
    channel.write(ByteBuffer.wrap(text.getBytes(StandardCharsets.US_ASCII)));
  }

  @Override
  public void close() throws IOException {
    channel.close();
  }

  /** The simulated world at one instant. */
  public record Truth(Map<String, String> values) {

    long number(String name) {
      return Long.parseLong(text(name));
    }

    public double decimal(String name) {
      return Double.parseDouble(text(name));
    }

    String text(String name) {
      return Objects.requireNonNull(values.get(name), name);
    }

    Duration now() {
      return time("us");
    }

    /** When a wheel last turned faster than what counts as standing. */
    Duration moved() {
      return time("moved_us");
    }

    /** From the last exchange until the wheels had stopped. */
    public Duration rolledOn() {
      return moved().minus(time("exchanged_us"));
    }

    private Duration time(String name) {
      return Duration.ofNanos(1_000 * number(name));
    }
  }
}
