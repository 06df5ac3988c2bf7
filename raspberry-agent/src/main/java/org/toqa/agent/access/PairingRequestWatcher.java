package org.toqa.agent.access;

import java.io.IOException;
import java.util.function.Consumer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.link.trust.PairingCode;

/** Looks for requests to pair for as long as a daemon runs, on a virtual thread of its own. */
final class PairingRequestWatcher implements AutoCloseable {

  private static final Logger log = LoggerFactory.getLogger(PairingRequestWatcher.class);

  private final String robot;
  private final PairingRequestFile request;
  private final Consumer<PairingCode> onRequest;
  private final Thread thread;

  PairingRequestWatcher(String robot, PairingRequestFile request, Consumer<PairingCode> taken) {
    this.robot = robot;
    this.request = request;
    this.onRequest = taken;
    thread = Thread.ofVirtual().name(robot + "-pairing").start(this::run);
  }

  @Override
  public void close() {
    thread.interrupt();
  }

  private void run() {
    try {
      while (true) {
        poll();
        Thread.sleep(PairingRequestFile.POLL_INTERVAL);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt(); // only close() interrupts
    }
  }

  private void poll() {
    try {
      request
          .take()
          .ifPresent(
              code -> {
                onRequest.accept(code);
                log.info("{}: was asked to pair, and takes a new code.", robot);
              });
    } catch (IOException e) {
      log.warn("{}: a request to pair was refused: {}", robot, e.getMessage());
    }
  }
}
