package org.toqa.testbed;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.time.Duration;
import java.util.Base64;
import java.util.List;
import java.util.concurrent.TimeUnit;

/**
 * A Mosquitto for one test, with users and rights as {@code docs/telemetry.md} has them. For tests
 * tagged {@code full}.
 */
public final class OwnMosquitto implements AutoCloseable {
  public static final String SERVER = "toqa";

  /** Of everybody. */
  public static final String PASSWORD = "of-everybody";

  /** Of that length alone. */
  private static final String SALT = "toqa-testing";

  /** That password as Mosquitto stores it, in its format 6: SHA-512 with a salt. */
  private static final String STORED =
      "$6$"
          + Base64.getEncoder().encodeToString(SALT.getBytes(StandardCharsets.UTF_8))
          + "$"
          + sha512(PASSWORD + SALT);

  private static final Duration LIMIT = Duration.ofMinutes(2);

  private final Path folder;
  private int port;
  private Process server;

  /**
   * @param folder holds its configuration and its log
   */
  public OwnMosquitto(Path folder) throws Exception {
    this.folder = folder;
    Files.writeString(
        folder.resolve("users"),
        String.join(
            "",
            List.of(SERVER, "main/robot/r1", "main/robot/r2", "main/reader").stream()
                .map(user -> user + ":" + STORED + "\n")
                .toList()));
    Files.writeString(
        folder.resolve("rights"),
        """
        pattern readwrite toqa/v1/%u/#
        user main/reader
        topic read toqa/v1/main/#
        user toqa
        topic readwrite toqa/v1/#
        """);
    for (int tries = 5; tries > 0; tries--) {
      port = freePort();
      server = launch();
      if (answers()) {
        return;
      }
    }
    throw new AssertionError("Mosquitto does not start: " + log());
  }

  private static String sha512(String text) {
    try {
      return Base64.getEncoder()
          .encodeToString(
              MessageDigest.getInstance("SHA-512").digest(text.getBytes(StandardCharsets.UTF_8)));
    } catch (NoSuchAlgorithmException e) {
      throw new AssertionError("Every Java has SHA-512.", e);
    }
  }

  private static int freePort() throws IOException {
    try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      return socket.getLocalPort();
    }
  }

  private Process launch() throws IOException {
    Path configuration = folder.resolve("mosquitto.conf");
    Files.writeString(
        configuration,
        """
        listener %d 127.0.0.1
        allow_anonymous false
        password_file %s
        acl_file %s
        user %s
        """
            .formatted(
                port,
                folder.resolve("users"),
                folder.resolve("rights"),
                System.getProperty("user.name")));
    return new ProcessBuilder(
            Path.of("src/test/services/own-mosquitto.sh").toAbsolutePath().toString(),
            configuration.toString())
        .redirectErrorStream(true)
        .redirectOutput(ProcessBuilder.Redirect.appendTo(folder.resolve("log").toFile()))
        .start();
  }

  public int port() {
    return port;
  }

  /** As {@code kill -9} does it. */
  public void kill() {
    server.destroyForcibly().onExit().join();
  }

  public void startAgain() throws Exception {
    server = launch();
    if (!answers()) {
      throw new AssertionError("Mosquitto does not start again: " + log());
    }
  }

  /** False where the port was taken; an {@link AssertionError} where it does not start at all. */
  private boolean answers() throws Exception {
    long end = System.nanoTime() + LIMIT.toNanos();
    while (server.isAlive() && System.nanoTime() < end) {
      try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
        if (socket.isConnected() && server.isAlive()) {
          return true;
        }
      } catch (IOException e) {
        TimeUnit.MILLISECONDS.sleep(50); // it is not up yet
      }
    }
    close();
    if (log().contains("Address already in use")) {
      return false;
    }
    throw new AssertionError("Mosquitto does not start: " + log());
  }

  private String log() throws IOException {
    return Files.readString(folder.resolve("log"));
  }

  @Override
  public void close() {
    kill();
  }
}
