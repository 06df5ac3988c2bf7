package org.toqa.telemetry.mqtt;

import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.time.InstantSource;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HexFormat;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ThreadLocalRandom;
import org.eclipse.paho.client.mqttv3.IMqttDeliveryToken;
import org.eclipse.paho.client.mqttv3.IMqttToken;
import org.eclipse.paho.client.mqttv3.MqttAsyncClient;
import org.eclipse.paho.client.mqttv3.MqttCallback;
import org.eclipse.paho.client.mqttv3.MqttConnectOptions;
import org.eclipse.paho.client.mqttv3.MqttException;
import org.eclipse.paho.client.mqttv3.MqttMessage;
import org.eclipse.paho.client.mqttv3.persist.MemoryPersistence;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.SnapshotFeed;
import org.toqa.telemetry.ReadingBoard;
import org.toqa.telemetry.Topics;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * A site's connection to its broker (Eclipse Paho), on a virtual thread of its own: takes in what
 * robots publish and publishes what the fleet does, until it is closed. Where the broker is away it
 * is tried again and again, and everything is published anew.
 */
public final class BrokerConnection implements AutoCloseable {
  private static final Logger log = LoggerFactory.getLogger(BrokerConnection.class);

  private static final int QOS = 1;
  private static final byte[] ONLINE = "online".getBytes(StandardCharsets.UTF_8);
  private static final byte[] OFFLINE = "offline".getBytes(StandardCharsets.UTF_8);

  /** Messages that the broker has not acknowledged. */
  private static final int MAX_IN_FLIGHT = 50;

  private static final int KEEP_ALIVE_SECONDS = 10;
  private static final int CONNECT_SECONDS = 5;
  private static final Duration ANSWER_LIMIT = Duration.ofSeconds(10);
  private static final Duration CLOSE_LIMIT = Duration.ofSeconds(2);
  private static final Duration SHORTEST_PAUSE = Duration.ofSeconds(1);
  private static final Duration LONGEST_PAUSE = Duration.ofSeconds(10);

  /** Between two rounds of states at least. */
  private static final Duration ROUND = Duration.ofMillis(500);

  /**
   * Everything is published again: a broker that keeps a message only after it has passed it on
   * tells nobody of it who subscribes in between.
   */
  private static final Duration REFRESH = Duration.ofSeconds(10);

  /** So long the broker tells what it has kept, after the subscription. */
  private static final Duration FINDING = Duration.ofSeconds(5);

  private final BrokerAddress address;
  private final @Nullable String user;
  private final @Nullable String password;
  private final Topics topics;
  private final ReadingBoard board;
  private final StateWriter writer;
  private final SnapshotFeed feed;
  private final InstantSource clock;
  private final Thread thread;
  private volatile boolean isClosing;

  /** Null while it is connected, and before the first attempt. */
  private volatile @Nullable Sentence trouble;

  /**
   * @param user null: the broker wants none
   */
  public BrokerConnection(
      BrokerAddress address,
      @Nullable String user,
      @Nullable String password,
      Topics topics,
      ReadingBoard board,
      StateWriter writer,
      SnapshotFeed feed,
      InstantSource clock) {
    this.address = address;
    this.user = user;
    this.password = password;
    this.topics = topics;
    this.board = board;
    this.writer = writer;
    this.feed = feed;
    this.clock = clock;
    this.thread = Thread.ofVirtual().name("mqtt-" + topics.site()).unstarted(this::run);
  }

  public void start() {
    thread.start();
  }

  /** Why nothing is heard and published now; empty while it is, and before it was tried. */
  public Optional<Sentence> trouble() {
    return Optional.ofNullable(trouble);
  }

  private void run() {
    Duration pause = SHORTEST_PAUSE;
    while (!isClosing) {
      try (Session session = new Session()) {
        session.open();
        setTrouble(null);
        pause = SHORTEST_PAUSE;
        session.serve();
      } catch (MqttException e) {
        setTrouble(Phrase.MQTT_BROKER_AWAY.with(address.shown(), reason(e)));
      } catch (InterruptedException e) {
        break; // it is closed
      } catch (RuntimeException e) {
        log.error("The connection to {} has a fault; it is made anew.", address.shown(), e);
      }
      try {
        Thread.sleep(pause);
      } catch (InterruptedException e) {
        break;
      }
      pause =
          pause.multipliedBy(2).compareTo(LONGEST_PAUSE) > 0
              ? LONGEST_PAUSE
              : pause.multipliedBy(2);
    }
  }

  private static String reason(MqttException e) {
    Throwable cause = e.getCause();
    return String.valueOf(cause == null ? e.getMessage() : cause.getMessage());
  }

  private void setTrouble(@Nullable Sentence now) {
    if (!isClosing && (now == null) != (trouble == null)) {
      if (now == null) {
        log.info("The MQTT broker {} answers again.", address.shown());
      } else {
        log.warn("{}", now.english());
      }
    }
    trouble = now;
  }

  /** One connection, from its begin to its loss. */
  private final class Session implements AutoCloseable, MqttCallback {
    private final MqttAsyncClient client;
    private final StatePublication states = new StatePublication(topics, writer);
    private final Deque<IMqttToken> inFlight = new ArrayDeque<>();

    private Session() throws MqttException {
      byte[] random = new byte[8];
      ThreadLocalRandom.current().nextBytes(random);
      client =
          new MqttAsyncClient(
              address.uri(), "toqa-" + HexFormat.of().formatHex(random), new MemoryPersistence());
      client.setCallback(this);
    }

    private void open() throws MqttException {
      client.connect(options()).waitForCompletion(ANSWER_LIMIT.toMillis());
      client.subscribe(topics.ofRobots(), 0).waitForCompletion(ANSWER_LIMIT.toMillis());
      client.subscribe(topics.ofTasks(), 0).waitForCompletion(ANSWER_LIMIT.toMillis());
    }

    private MqttConnectOptions options() {
      MqttConnectOptions options = new MqttConnectOptions();
      options.setMqttVersion(MqttConnectOptions.MQTT_VERSION_3_1_1);
      options.setCleanSession(true);
      options.setSocketFactory(address.sockets());
      options.setHttpsHostnameVerificationEnabled(!address.isOwn());
      options.setKeepAliveInterval(KEEP_ALIVE_SECONDS);
      options.setConnectionTimeout(CONNECT_SECONDS);
      options.setMaxInflight(2 * MAX_IN_FLIGHT);
      options.setWill(topics.server(), OFFLINE, QOS, true);
      if (user != null) {
        options.setUserName(user);
        options.setPassword((password == null ? "" : password).toCharArray());
      }
      return options;
    }

    /** Returns when the connection is lost. */
    private void serve() throws MqttException, InterruptedException {
      publish(topics.server(), ONLINE);
      long begin = System.nanoTime();
      long refreshed = begin;
      boolean isFinding = true;
      long seen = -1;
      while (client.isConnected()) {
        FleetSnapshot snapshot = feed.awaitNewer(seen, ROUND);
        seen = snapshot.version();
        board.update(clock.instant());
        if (System.nanoTime() - refreshed > REFRESH.toNanos()) {
          refreshed = System.nanoTime();
          publish(topics.server(), ONLINE);
          states.startAnew();
        }
        for (Map.Entry<String, byte[]> change : states.changes(snapshot).entrySet()) {
          publish(change.getKey(), change.getValue());
        }
        if (isFinding && System.nanoTime() - begin > FINDING.toNanos()) {
          isFinding = false;
          client.unsubscribe(topics.ofTasks()).waitForCompletion(ANSWER_LIMIT.toMillis());
        }
        Thread.sleep(ROUND);
      }
      throw new MqttException(MqttException.REASON_CODE_CONNECTION_LOST);
    }

    private void publish(String topic, byte[] body) throws MqttException {
      while (inFlight.size() >= MAX_IN_FLIGHT) {
        inFlight.remove().waitForCompletion(ANSWER_LIMIT.toMillis());
      }
      inFlight.add(client.publish(topic, body, QOS, true));
    }

    @Override
    public void messageArrived(String topic, MqttMessage message) {
      if (topics.isState(topic)) {
        if (message.isRetained()) {
          states.addFound(topic);
        }
      } else {
        board.receive(
            topics.origin(topic), message.getPayload(), message.isRetained(), clock.instant());
      }
    }

    @Override
    public void connectionLost(Throwable cause) {
      // serve() sees it within a round
    }

    @Override
    public void deliveryComplete(IMqttDeliveryToken token) {
      // each is waited for where it has to be
    }

    /** Says goodbye where the broker still hears it. */
    @Override
    public void close() {
      boolean wasInterrupted = Thread.interrupted(); // while it was closed; what follows waits
      try {
        if (client.isConnected()) {
          client
              .publish(topics.server(), OFFLINE, QOS, true)
              .waitForCompletion(CLOSE_LIMIT.toMillis());
          client.disconnect(0).waitForCompletion(CLOSE_LIMIT.toMillis());
        }
      } catch (MqttException e) {
        log.debug("The broker is away.", e);
      }
      try {
        client.disconnectForcibly(0, 0, false);
      } catch (MqttException e) {
        log.debug("It is disconnected already.", e);
      }
      try {
        client.close(true);
      } catch (MqttException e) {
        log.debug("The client does not end cleanly.", e);
      }
      if (wasInterrupted) {
        Thread.currentThread().interrupt();
      }
    }
  }

  @Override
  public void close() {
    isClosing = true;
    thread.interrupt();
    try {
      if (!thread.join(CLOSE_LIMIT.multipliedBy(3))) {
        log.warn("The connection to {} does not end.", address.shown());
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
