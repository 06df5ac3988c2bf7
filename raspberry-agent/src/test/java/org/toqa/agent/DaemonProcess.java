package org.toqa.agent;

import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.DecodeResult.Decoded;
import org.toqa.link.message.LineReader;
import org.toqa.link.message.LinkCodec;
import org.toqa.link.message.ServerMessage;

/** A daemon as a process of its own, in real time, to be killed. */
public final class DaemonProcess implements AutoCloseable {

  private static final Duration LIMIT = Duration.ofSeconds(20);

  private final Process process;
  private final BufferedReader output;
  private final int port;

  private DaemonProcess(Process process, BufferedReader output, int port) {
    this.process = process;
    this.output = output;
    this.port = port;
  }

  /** Starts the process; it listens when this returns. */
  public static DaemonProcess launch(Path config, String... options) throws IOException {
    List<String> command =
        new ArrayList<>(
            List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Xmx64m",
                "-XX:+UseSerialGC",
                "-XX:TieredStopAtLevel=1", // as on the robot; it starts in half the time
                "-cp",
                System.getProperty("java.class.path"),
                "org.toqa.agent.Main",
                "--config",
                config.toString()));
    command.addAll(List.of(options));
    Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
    BufferedReader output = process.inputReader(StandardCharsets.UTF_8);
    String line = output.readLine();
    while (line != null && !line.contains("listening on")) {
      line = output.readLine();
    }
    assertNotNull(line, "the daemon ended");
    return new DaemonProcess(
        process, output, Integer.parseInt(line.replaceAll(".* port (\\d+)\\.", "$1")));
  }

  /** What it writes from now on. */
  BufferedReader output() {
    return output;
  }

  /** The code that it shows, as it prints it. */
  public String pairingCode() throws IOException {
    String line = output.readLine();
    while (line != null && !line.startsWith("Pairing code: ")) {
      line = output.readLine();
    }
    assertNotNull(line, "no code was shown");
    return line.replaceAll("Pairing code: (\\S+) .*", "$1");
  }

  Process process() {
    return process;
  }

  public int port() {
    return port;
  }

  public Peer connect() throws IOException {
    return new Peer();
  }

  void terminate() throws InterruptedException {
    process.toHandle().destroy(); // unlike Process.destroy it leaves the output open
    assertTrue(process.waitFor(10, TimeUnit.SECONDS));
  }

  public void kill() throws InterruptedException {
    process.destroyForcibly();
    assertTrue(process.waitFor(10, TimeUnit.SECONDS));
  }

  int exitCode() {
    return process.exitValue();
  }

  @Override
  public void close() {
    process.destroyForcibly();
  }

  /** A server of the daemon. */
  public final class Peer implements AutoCloseable {
    private final Socket socket = new Socket(InetAddress.getLoopbackAddress(), port);
    private final LineReader lines = new LineReader(socket.getInputStream());

    Peer() throws IOException {
      socket.setSoTimeout((int) LIMIT.toMillis());
    }

    public void say(ServerMessage message) throws IOException {
      socket.getOutputStream().write(LinkCodec.encode(message));
    }

    public <M extends AgentMessage> M await(Class<M> type, Predicate<M> wanted) throws IOException {
      while (true) {
        LineReader.Line line = lines.readLine();
        assertNotNull(line, "the daemon hung up");
        Object message =
            assertInstanceOf(Decoded.class, LinkCodec.decodeAgentMessage(line)).message();
        if (type.isInstance(message) && wanted.test(type.cast(message))) {
          return type.cast(message);
        }
      }
    }

    @Override
    public void close() throws IOException {
      socket.close();
    }
  }
}
