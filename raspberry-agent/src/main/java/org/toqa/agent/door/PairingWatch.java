package org.toqa.agent.door;

import java.io.IOException;
import java.util.function.Consumer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.link.trust.PairingCode;

/** Looks for requests to pair for as long as a daemon runs, on a virtual thread of its own. */
final class PairingWatch implements AutoCloseable {

  private static final Logger log = LoggerFactory.getLogger(PairingWatch.class);

  private final String robot;
  private final PairingRequest request;
  private final Consumer<PairingCode> taken;
  private final Thread thread;

  PairingWatch(String robot, PairingRequest request, Consumer<PairingCode> taken) {
    this.robot = robot;
    this.request = request;
    this.taken = taken;
    thread = Thread.ofVirtual().name(robot + "-pairing").start(this::run);
  }

  @Override
  public void close() {
    thread.interrupt();
  }

  private void run() {
    try {
      while (true) {
        look();
        Thread.sleep(PairingRequest.LOOKS);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt(); // only close() interrupts
    }
  }

  private void look() {
    try {
      request
          .take()
          .ifPresent(
              code -> {
                taken.accept(code);
                log.info("{}: was asked to pair, and takes a new code.", robot);
              });
    } catch (IOException e) {
      log.warn("{}: a request to pair was refused: {}", robot, e.getMessage());
    }
  }
}
