package org.toqa.app.server;

import java.io.IOException;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.file.Path;
import java.time.Duration;
import java.time.InstantSource;
import java.util.concurrent.locks.LockSupport;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.agent.access.LinkEndpoint;
import org.toqa.agent.storage.DataFolderInUseException;
import org.toqa.link.RobotAddress;
import org.toqa.link.RobotLink;
import org.toqa.link.RobotLinkFactory;
import org.toqa.link.channel.Backoff;
import org.toqa.link.http.ExchangeListener;
import org.toqa.link.http.HttpRobotAddress;
import org.toqa.link.http.HttpRobotClient;
import org.toqa.link.http.HttpRobotException;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.ServerMessage;
import org.toqa.link.trust.Fingerprint;
import org.toqa.localisation.RangeSource;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * The link to a robot that takes wheel commands over HTTP: a daemon of its own, which runs here
 * while the robot answers, and the robot link to that.
 *
 * <ol>
 *   <li>The robot is asked what it is.
 *   <li>Its daemon is opened over that body, as the paired robot of this server, and ticked by the
 *       link's thread, by the machine's clock: the robot is a real one.
 *   <li>When the robot has not answered for {@link #LOST_AFTER}, or does not take the token, the
 *       daemon is closed, the listener told why, and all of it tried again, later and later.
 * </ol>
 */
final class HttpRobotLink implements RobotLink, ExchangeListener {
  private static final Logger log = LoggerFactory.getLogger(HttpRobotLink.class);

  /** Of silence; a robot that is not heard for 2 s counts as lost. */
  private static final Duration LOST_AFTER = Duration.ofMillis(1500);

  /** A daemon that ran for less is opened later and later. */
  private static final long LASTING_NANOS = 2 * Backoff.LONGEST.toNanos();

  private final RobotAddress address;
  private final HttpRobotAddress robot;
  private final Surroundings surroundings;
  private final Listener listener;
  private final Backoff backoff = new Backoff();
  private final Thread thread;
  private volatile boolean closed;
  private volatile @Nullable RobotLink link;

  /** Null since it was heard last. */
  private volatile @Nullable Sentence lastFailure;

  // of the daemon that runs, by the link's thread
  private long answeredAt;
  private @Nullable HttpRobotException failure;

  /**
   * What links of a site have in common.
   *
   * @param daemonLinks to the daemons that this server runs
   * @param folder of the robot's daemon
   * @param server the certificate by which the daemon knows the server
   * @param plainOffLoopback whether a robot on another machine may do without encryption
   * @param ranges that the robot publishes
   * @param clock for stamps
   */
  record Surroundings(
      RobotLinkFactory daemonLinks,
      Path folder,
      Fingerprint server,
      boolean plainOffLoopback,
      RangeSource ranges,
      InstantSource clock) {}

  HttpRobotLink(
      RobotAddress address, HttpRobotAddress robot, Surroundings surroundings, Listener listener) {
    this.address = address;
    this.robot = robot;
    this.surroundings = surroundings;
    this.listener = listener;
    // no virtual thread: its ticks are on time, whatever other work waits for
    thread = Thread.ofPlatform().daemon().name("http-" + address.robot()).unstarted(this::run);
  }

  void start() {
    thread.start();
  }

  @Override
  public void send(ServerMessage message) {
    RobotLink now = link;
    if (now != null) {
      now.send(message);
    }
  }

  @Override
  public void close() {
    closed = true;
    LockSupport.unpark(thread); // which ends its daemon before itself
  }

  private void run() {
    while (!closed) {
      long begun = System.nanoTime();
      try {
        driveWhileItAnswers();
      } catch (HttpRobotException e) {
        tell(sentence(e), e.isTrustFailure());
      } catch (DataFolderInUseException e) {
        log.debug("{}: the link before this one ends.", address.robot());
      } catch (IOException e) {
        log.warn("{}: its daemon could not be run: {}", address.robot(), e.getMessage());
        tell(
            Phrase.HTTP_CANNOT_BE_DRIVEN.with(address.robot(), String.valueOf(e.getMessage())),
            false);
      } catch (RuntimeException e) { // of this robot, never of the server
        log.error("{}: its daemon failed.", address.robot(), e);
        tell(Phrase.HTTP_CANNOT_BE_DRIVEN.with(address.robot(), String.valueOf(e)), false);
      }
      if (System.nanoTime() - begun > LASTING_NANOS) {
        backoff.reset();
      }
      pause();
    }
  }

  private void driveWhileItAnswers() throws IOException {
    if (!isGuarded()) {
      tell(Phrase.HTTP_NOT_ENCRYPTED.with(address.robot(), address.place()), true);
      return;
    }
    LinkEndpoint.pinServer(surroundings.folder(), surroundings.server());
    answeredAt = System.nanoTime();
    failure = null;
    Relay relay = new Relay();
    try (HttpRobotClient client = new HttpRobotClient(robot);
        HttpRobotDaemon daemon =
            HttpRobotDaemon.open(
                address.robot(),
                surroundings.folder(),
                client,
                this,
                surroundings.ranges(),
                surroundings.clock());
        RobotLink opened = surroundings.daemonLinks().open(daemon.address(), relay)) {
      link = opened;
      daemon.run(() -> !closed && !isLost());
    } finally {
      link = null;
      relay.end();
    }
    if (failure != null && !closed) {
      throw failure;
    }
  }

  /** Whether what is said is encrypted, or need not be. */
  private boolean isGuarded() {
    if (robot.fingerprint() != null || surroundings.plainOffLoopback()) {
      return true;
    }
    try {
      return InetAddress.getByName(robot.host()).isLoopbackAddress();
    } catch (UnknownHostException e) {
      return true; // which is said when it is connected to
    }
  }

  private boolean isLost() {
    HttpRobotException why = failure;
    return why != null
        && (why.isTrustFailure() || System.nanoTime() - answeredAt > LOST_AFTER.toNanos());
  }

  @Override
  public void answered(long nanos) {
    answeredAt = System.nanoTime();
    failure = null;
    lastFailure = null;
  }

  @Override
  public void failed(HttpRobotException why) {
    failure = why;
  }

  private Sentence sentence(HttpRobotException e) {
    String name = address.robot();
    String place = address.place();
    return switch (e.reason()) {
      case HOST_NOT_KNOWN -> Phrase.HOST_NOT_KNOWN.with(name, place);
      case NOBODY_LISTENS -> Phrase.NOBODY_LISTENS.with(name, place);
      case DOES_NOT_ANSWER -> Phrase.DOES_NOT_ANSWER.with(name, place);
      case CANNOT_BE_REACHED -> Phrase.CANNOT_BE_REACHED.with(name, place, message(e));
      case WRONG_TOKEN -> Phrase.HTTP_WRONG_TOKEN.with(name, place);
      case ANOTHER_CERTIFICATE -> Phrase.HTTP_ANOTHER_CERTIFICATE.with(place, name);
      case REFUSES -> Phrase.HTTP_REFUSES.with(name, place, message(e));
      case NONSENSE -> Phrase.HTTP_MAKES_NO_SENSE.with(name, place, message(e));
    };
  }

  private static String message(IOException e) {
    return String.valueOf(e.getMessage());
  }

  /** Once for each reason, not once for each attempt. */
  private void tell(Sentence sentence, boolean isTrustFailure) {
    if (closed || sentence.equals(lastFailure)) {
      return;
    }
    lastFailure = sentence;
    if (isTrustFailure) {
      listener.refused(sentence);
    } else {
      listener.disconnected(sentence);
    }
  }

  private void pause() {
    long end = System.nanoTime() + backoff.nextDelay().toNanos();
    for (long left = end - System.nanoTime(); !closed && left > 0; left = end - System.nanoTime()) {
      LockSupport.parkNanos(left);
    }
  }

  /** Hands on what the daemon says, until it is to be closed: one call at a time, as promised. */
  private final class Relay implements Listener {
    private boolean isEnded;

    synchronized void end() {
      isEnded = true;
    }

    @Override
    public synchronized void connected(Hello hello) {
      if (!isEnded) {
        lastFailure = null; // what follows is news, though it may be the same
        listener.connected(hello);
      }
    }

    @Override
    public synchronized boolean received(AgentMessage message) {
      return isEnded || listener.received(message);
    }

    @Override
    public synchronized void passedOver(int states, int unreadable) {
      if (!isEnded) {
        listener.passedOver(states, unreadable);
      }
    }

    @Override
    public synchronized void disconnected(Sentence why) {
      if (!isEnded) {
        listener.disconnected(why);
      }
    }

    @Override
    public synchronized void refused(Sentence why) {
      if (!isEnded) {
        listener.refused(why);
      }
    }
  }
}
