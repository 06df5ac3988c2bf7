package org.toqa.testbed;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/**
 * Where network interfaces come and go Chromium drops what it is loading, also from this very
 * machine. So nobody changes them while anybody browses, in whatever process of the suite.
 */
final class NetworkLock implements AutoCloseable {
  private static final Path FILE = Path.of("target", "network.lock");

  private final FileChannel channel;

  private NetworkLock(boolean isShared) throws IOException {
    Files.createDirectories(FILE.getParent());
    channel =
        FileChannel.open(
            FILE, StandardOpenOption.CREATE, StandardOpenOption.READ, StandardOpenOption.WRITE);
    channel.lock(0, Long.MAX_VALUE, isShared);
  }

  /** Waits until nobody browses. */
  static NetworkLock toChange() throws IOException {
    return new NetworkLock(false);
  }

  /** Waits until nobody changes interfaces; several may browse at once. */
  static NetworkLock toBrowse() throws IOException {
    return new NetworkLock(true);
  }

  @Override
  public void close() throws IOException {
    channel.close();
  }
}
