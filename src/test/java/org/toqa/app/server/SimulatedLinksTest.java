package org.toqa.app.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.geometry.Pose;
import org.toqa.link.RobotAddress;
import org.toqa.link.RobotLink;
import org.toqa.link.TcpRobotLinkFactory;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.ServerMessage;
import org.toqa.link.trust.IdentityFile;
import org.toqa.link.trust.LinkTls;
import org.toqa.sim.SimulatedFleet;
import org.toqa.sim.SimulatedFloor;
import org.toqa.sim.SimulatedRobot;
import org.toqa.sim.VirtualClock;
import org.toqa.wording.Sentence;

/** A real daemon in a world that runs fast, and a server whose thread for it is held up. */
@Timeout(60)
class SimulatedLinksTest {
  private static final long SECOND = Duration.ofSeconds(1).toNanos();

  @TempDir private Path folder;
  private VirtualClock clock;
  private SimulatedFleet robots;
  private SimulatedLinks links;
  private RobotLink link;
  private final CompletableFuture<RobotLink> opened = new CompletableFuture<>();
  private final AtomicLong number = new AtomicLong();
  private final HeldUp server = new HeldUp();

  @BeforeEach
  void openLink() throws Exception {
    clock = new VirtualClock(Instant.EPOCH, 50);
    robots =
        SimulatedFleet.open(
            folder,
            List.of(new SimulatedRobot("r1", new Pose(1.5, 1.5, 0), 5, 1)),
            SimulatedFloor.boundless(),
            clock);
    links =
        new SimulatedLinks(
            new TcpRobotLinkFactory(new LinkTls(IdentityFile.open(folder)), false),
            robots::isListeningOn,
            clock::nanos);
    clock.add(links, VirtualClock.STEP);
    clock.add(nanos -> ping(), Duration.ofMillis(500));
    clock.start();
    link = links.open(new RobotAddress("r1", "127.0.0.1", robots.port("r1"), null), server);
    opened.complete(link);
  }

  /** As the server does it: at once, and then again and again. */
  private void ping() {
    var _ = opened.thenAccept(to -> to.send(new ServerMessage.Ping(number.incrementAndGet())));
  }

  @AfterEach
  void close() {
    server.onward.countDown();
    link.close();
    clock.close();
    robots.close();
  }

  @Test
  void worldWaitsUntilWhatARobotSaidIsRead() throws Exception {
    assertTrue(server.isHeldUp.await(30, TimeUnit.SECONDS));
    while (links.isReady(clock.nanos())) {
      Thread.onSpinWait();
    }
    long standing = clock.nanos();
    assertFalse(clock.isReady());
    assertEquals("what is said by r1", links.toString());
    assertTrue(links.isReady(standing + 2 * SECOND), "a robot that is lost");
    TimeUnit.MILLISECONDS.sleep(200); // ten seconds of a world that does not wait
    assertEquals(standing, clock.nanos());
    assertTrue(standing - server.heldUpAt <= SECOND + VirtualClock.STEP.toNanos());

    server.onward.countDown();
    while (clock.nanos() < standing + 10 * SECOND) {
      Thread.onSpinWait();
    }
  }

  @Test
  void linkThatIsClosedIsNotWaitedFor() throws Exception {
    assertTrue(server.isHeldUp.await(30, TimeUnit.SECONDS));
    link.close();
    server.onward.countDown();
    long closedAt = clock.nanos();
    while (clock.nanos() < closedAt + 10 * SECOND) {
      Thread.onSpinWait();
    }
    assertTrue(links.isReady(clock.nanos()));
  }

  /** Its thread stops at the robot's third message until it may go on. */
  private final class HeldUp implements RobotLink.Listener {
    final CountDownLatch onward = new CountDownLatch(1);
    final CountDownLatch isHeldUp = new CountDownLatch(1);
    volatile long heldUpAt;
    private int count;

    @Override
    public void connected(Hello hello) {
      ping();
    }

    @Override
    public boolean received(AgentMessage message) {
      if (++count == 3) {
        heldUpAt = clock.nanos();
        isHeldUp.countDown();
        try {
          onward.await();
        } catch (InterruptedException e) {
          Thread.currentThread().interrupt();
        }
      }
      return true;
    }

    @Override
    public void passedOver(int states, int unreadable) {}

    @Override
    public void disconnected(Sentence why) {}

    @Override
    public void refused(Sentence sentence) {}
  }
}
