package org.toqa.agent.routing;

import java.io.IOException;
import java.net.InetAddress;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.agent.config.AdHocNetwork;
import org.toqa.link.channel.Backoff;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.AgentMessage.NetworkRoute;

/**
 * A robot's place in an ad hoc network, by a babeld of its own.
 *
 * <ol>
 *   <li>{@link #open} checks the machine and starts babeld, or takes over the one that an earlier
 *       daemon has left.
 *   <li>A thread asks it each second for its routes, and starts it again when it has ended or does
 *       not answer.
 *   <li>{@link #routeTo} and {@link #fault} tell how it is now; they never wait, and any thread may
 *       call them.
 *   <li>{@link #close} ends babeld, which takes its routes back.
 * </ol>
 */
public final class Babeld implements AutoCloseable {

  private static final Logger log = LoggerFactory.getLogger(Babeld.class);

  private static final Duration BETWEEN_QUESTIONS = Duration.ofSeconds(1);
  private static final Duration LONGEST_ANSWER = Duration.ofSeconds(5);
  private static final Duration BETWEEN_TRIES = Duration.ofMillis(50);
  private static final Duration LONGEST_CLOSE = Duration.ofSeconds(3);

  private final String robot;
  private final BabeldProcess babeld;
  private final CountDownLatch closed = new CountDownLatch(1);
  private final Thread thread;
  private volatile RouteTable table = RouteTable.EMPTY;
  private volatile @Nullable Fault fault;

  /**
   * @param robot its name, for the log
   * @param folder of the daemon's data
   * @throws IOException with a sentence for people: what the machine lacks
   */
  public static Babeld open(String robot, AdHocNetwork network, Path folder) throws IOException {
    return open(robot, network, folder, HostCheck.here());
  }

  static Babeld open(String robot, AdHocNetwork network, Path folder, HostCheck host)
      throws IOException {
    BabeldProcess babeld =
        new BabeldProcess(
            host.program("babeld"), host.program("ip"), folder, BabeldFile.text(network));
    host.check(network);
    try {
      Optional<ProcessHandle> left = babeld.takeOver();
      if (left.isEmpty()) {
        host.checkAlone();
      }
      ProcessHandle process = left.isPresent() ? left.get() : babeld.start();
      log.info(
          "{}: babeld {} on {}.",
          robot,
          left.isPresent() ? "goes on" : "is started",
          String.join(", ", network.interfaces()));
      if (network.key() == null) {
        log.warn(
            "{}: adHocNetwork.key is not set, so whoever is in reach can lead packets astray.",
            robot);
      }
      return new Babeld(robot, babeld, process);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("Interrupted before babeld was started.", e);
    }
  }

  /**
   * @param process the one that runs
   */
  Babeld(String robot, BabeldProcess babeld, ProcessHandle process) {
    this.robot = robot;
    this.babeld = babeld;
    thread = Thread.ofPlatform().daemon().name(robot + "-routing").start(() -> supervise(process));
  }

  /** The route that packets to that address take now; empty: none is known. */
  public Optional<NetworkRoute> routeTo(InetAddress destination) {
    return table.routeTo(destination);
  }

  /** Why the robot is not in the network, for its server; empty: it is. */
  public Optional<Fault> fault() {
    return Optional.ofNullable(fault);
  }

  private void supervise(ProcessHandle first) {
    ProcessHandle process = first;
    Backoff backoff = new Backoff();
    try {
      while (!isClosedAfter(Duration.ZERO)) {
        String reason = read(process, backoff);
        if (isClosedAfter(Duration.ZERO)) {
          break;
        }
        report(reason);
        babeld.end(process);
        if (isClosedAfter(backoff.nextDelay())) {
          break;
        }
        try {
          process = babeld.start();
        } catch (IOException e) {
          log.warn("{}: babeld cannot be started: {}", robot, e.getMessage());
        }
      }
      babeld.end(process);
    } catch (InterruptedException e) {
      process.destroyForcibly();
      Thread.currentThread().interrupt();
    }
  }

  /** Reads its routes until it is closed or fails, and says why it failed: a clause. */
  private String read(ProcessHandle process, Backoff backoff) throws InterruptedException {
    try (LocalInterface local = connect(process)) {
      do {
        table = local.table();
        fault = null;
        backoff.reset();
        babeld.limitLog();
      } while (!isClosedAfter(BETWEEN_QUESTIONS));
      return "it is ended";
    } catch (IOException e) {
      return process.isAlive()
          ? String.valueOf(e.getMessage())
          : babeld.lastWords().orElse("it has ended");
    } finally {
      table = RouteTable.EMPTY;
    }
  }

  /** It listens a moment after its start. */
  private LocalInterface connect(ProcessHandle process) throws IOException, InterruptedException {
    long end = System.nanoTime() + LONGEST_ANSWER.toNanos();
    while (true) {
      try {
        return new LocalInterface(babeld.socket(), LONGEST_ANSWER);
      } catch (IOException e) {
        if (!process.isAlive() || System.nanoTime() > end || isClosedAfter(BETWEEN_TRIES)) {
          throw e;
        }
      }
    }
  }

  private void report(String reason) {
    String sentence =
        "babeld does not route, so the robot forwards for no other and finds no way round: %s. It is started again."
            .formatted(reason);
    if (fault == null) { // one that ends again and again is logged once
      log.warn("{}: {}", robot, sentence);
    }
    fault = new Fault("ROUTING", sentence);
  }

  private boolean isClosedAfter(Duration wait) throws InterruptedException {
    return closed.await(wait.toMillis(), TimeUnit.MILLISECONDS);
  }

  @Override
  public void close() {
    closed.countDown();
    try {
      thread.join(LONGEST_CLOSE);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
