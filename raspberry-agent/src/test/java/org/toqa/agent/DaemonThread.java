package org.toqa.agent;

import java.io.IOException;
import java.nio.file.Path;
import java.time.InstantSource;
import org.toqa.agent.config.AgentConfig;
import org.toqa.agent.config.ConfigException;

/** A daemon in real time on a thread of this process, that is ended as by its service manager. */
public final class DaemonThread implements AutoCloseable {
  private final Daemon daemon;
  private final RealTimeLoop loop;
  private final Thread thread;

  private DaemonThread(Daemon daemon) {
    this.daemon = daemon;
    loop = new RealTimeLoop(daemon, 1);
    thread = Thread.ofPlatform().name(daemon.robot()).start(loop);
  }

  /**
   * Starts it; it listens when this returns.
   *
   * @param pair whether it shows a code
   */
  public static DaemonThread start(Path config, boolean pair) throws IOException, ConfigException {
    AgentConfig settings = AgentConfig.read(config);
    return new DaemonThread(Daemon.open(settings, InstantSource.system(), System.nanoTime(), pair));
  }

  /** The code that it shows. */
  public String pairingCode() {
    return daemon.pairingCode().orElseThrow();
  }

  public int port() {
    return daemon.port();
  }

  /** Ends it, once; its folder is free then. */
  @Override
  public void close() throws IOException {
    loop.stop();
    try {
      thread.join();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("Interrupted before the daemon had ended.", e);
    }
    daemon.close();
  }
}
