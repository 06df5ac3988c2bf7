package org.toqa.app.bench;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.time.Duration;
import java.time.InstantSource;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.Stream;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.app.bench.meter.LatencySummary;
import org.toqa.app.robot.SimulatedHttpRobot;
import org.toqa.app.server.HttpRobotDaemon;
import org.toqa.geometry.Pose;
import org.toqa.link.RobotLink;
import org.toqa.link.RobotLinkFactory;
import org.toqa.link.TcpRobotLinkFactory;
import org.toqa.link.http.ExchangeListener;
import org.toqa.link.http.HttpRobotAddress;
import org.toqa.link.http.HttpRobotClient;
import org.toqa.link.http.HttpRobotException;
import org.toqa.link.http.RobotToken;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.State;
import org.toqa.link.message.ServerMessage.Drive;
import org.toqa.link.message.ServerMessage.Locate;
import org.toqa.link.trust.IdentityFile;
import org.toqa.link.trust.LinkTls;
import org.toqa.localisation.RangeSource;
import org.toqa.motion.Segment;
import org.toqa.wording.Sentence;

/** Robots that take wheel commands over HTTP and drive round circles, with their daemons. */
final class HttpRobotsRun implements AutoCloseable {
  private static final Logger log = LoggerFactory.getLogger(HttpRobotsRun.class);

  private static final Pose START = new Pose(0, 0, 0);

  /** An hour round a circle of half a metre. */
  private static final Segment CIRCLE = new Segment(0.2, 0.4, 3600);

  private static final Duration START_LIMIT = Duration.ofMinutes(1);

  /** After the last robot has begun to drive. */
  private static final Duration SETTLING_TIME = Duration.ofSeconds(3);

  private final List<DrivenHttpRobot> robots = new ArrayList<>();
  private final Deque<AutoCloseable> parts = new ArrayDeque<>();
  private final int count;

  /**
   * What was measured with so many robots.
   *
   * @param exchange from the command to its answer
   * @param exchangesPerSecond of each robot, in the mean
   * @param failed exchanges without an answer
   * @param core processor seconds a second, of daemons and robots together
   */
  record Level(
      int robots, LatencySummary exchange, double exchangesPerSecond, long failed, double core) {}

  private HttpRobotsRun(int count) {
    this.count = count;
  }

  /**
   * Lets the robots drive.
   *
   * @param folder of their daemons
   * @throws IOException one of them does not
   */
  static HttpRobotsRun start(int count, Path folder) throws IOException, InterruptedException {
    HttpRobotsRun run = new HttpRobotsRun(count);
    try {
      LinkTls tls = new LinkTls(IdentityFile.open(folder));
      RobotLinkFactory links = new TcpRobotLinkFactory(tls, false);
      for (int i = 1; i <= count; i++) {
        run.add("h" + i, folder, links);
      }
      run.awaitDriving();
      return run;
    } catch (IOException | InterruptedException e) {
      run.close();
      throw e;
    }
  }

  private void add(String name, Path folder, RobotLinkFactory links) throws IOException {
    RobotToken token = RobotToken.random();
    SimulatedHttpRobot body = new SimulatedHttpRobot(SimulatedHttpRobot.Settings.of(token, START));
    parts.push(body);
    HttpRobotClient client =
        new HttpRobotClient(new HttpRobotAddress("127.0.0.1", body.port(), token, null));
    parts.push(client);
    DrivenHttpRobot robot = new DrivenHttpRobot();
    HttpRobotDaemon daemon =
        HttpRobotDaemon.open(
            name, folder.resolve(name), client, robot, RangeSource.NONE, InstantSource.system());
    parts.push(daemon);
    Thread thread = Thread.ofPlatform().daemon().start(() -> daemon.run(robot::goesOn));
    parts.push(() -> robot.stop(thread));
    RobotLink link = links.open(daemon.address(), robot);
    parts.push(link);
    robot.setLink(link);
    robots.add(robot);
  }

  private void awaitDriving() throws IOException, InterruptedException {
    for (DrivenHttpRobot robot : robots) {
      if (!robot.driving.await(START_LIMIT.toSeconds(), TimeUnit.SECONDS)) {
        throw new IOException("A robot does not drive.");
      }
    }
    Thread.sleep(SETTLING_TIME);
  }

  Level measure(int seconds) throws InterruptedException {
    robots.forEach(DrivenHttpRobot::reset);
    long began = System.nanoTime();
    long processor = processorNanos();
    Thread.sleep(Duration.ofSeconds(seconds));
    double took = System.nanoTime() - began;
    double core = (processorNanos() - processor) / took;
    double[] millis =
        robots.stream().flatMap(DrivenHttpRobot::times).mapToDouble(t -> t / 1e6).toArray();
    long failed = robots.stream().mapToLong(robot -> robot.failed.get()).sum();
    return new Level(
        count, LatencySummary.of(millis), millis.length / (took / 1e9) / count, failed, core);
  }

  private static long processorNanos() {
    return ManagementFactory.getOperatingSystemMXBean()
            instanceof com.sun.management.OperatingSystemMXBean system
        ? system.getProcessCpuTime()
        : 0;
  }

  @Override
  public void close() {
    while (!parts.isEmpty()) {
      try {
        parts.pop().close();
      } catch (Exception e) {
        log.warn("A part did not close cleanly.", e);
      }
    }
  }

  /** One robot: as its server it tells it to drive, and it measures its exchanges. */
  private static final class DrivenHttpRobot implements ExchangeListener, RobotLink.Listener {
    private final List<Long> nanos = Collections.synchronizedList(new ArrayList<>());
    private final AtomicLong failed = new AtomicLong();
    private final CountDownLatch driving = new CountDownLatch(1);
    private final CompletableFuture<RobotLink> link = new CompletableFuture<>();
    private volatile boolean isStopped;
    private boolean isTold;

    void setLink(RobotLink opened) {
      link.complete(opened);
    }

    boolean goesOn() {
      return !isStopped;
    }

    void stop(Thread thread) throws InterruptedException {
      isStopped = true;
      thread.join();
    }

    void reset() {
      nanos.clear();
      failed.set(0);
    }

    Stream<Long> times() {
      return List.copyOf(nanos).stream();
    }

    @Override
    public void answered(long took) {
      nanos.add(took);
    }

    @Override
    public void failed(HttpRobotException why) {
      failed.incrementAndGet();
    }

    @Override
    public void connected(Hello hello) {
      link.join().send(new Locate(1, START));
    }

    @Override
    public boolean received(AgentMessage message) {
      if (message instanceof State state) {
        if (state.localised() && !isTold) {
          isTold = true;
          link.join().send(new Drive(2, 1L, 1, START, List.of(CIRCLE), 1, true, 0));
        }
        if (state.mode() == Mode.DRIVING) {
          driving.countDown();
        }
      }
      return true;
    }

    @Override
    public void passedOver(int states, int unreadable) {}

    @Override
    public void disconnected(Sentence why) {}

    @Override
    public void refused(Sentence why) {}
  }
}
