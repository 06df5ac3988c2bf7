package org.toqa.testbed;

import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BooleanSupplier;
import java.util.function.Predicate;
import javax.net.SocketFactory;
import org.eclipse.paho.client.mqttv3.IMqttDeliveryToken;
import org.eclipse.paho.client.mqttv3.MqttAsyncClient;
import org.eclipse.paho.client.mqttv3.MqttCallback;
import org.eclipse.paho.client.mqttv3.MqttConnectOptions;
import org.eclipse.paho.client.mqttv3.MqttException;
import org.eclipse.paho.client.mqttv3.MqttMessage;
import org.eclipse.paho.client.mqttv3.persist.MemoryPersistence;
import org.jspecify.annotations.Nullable;

/** Somebody at an MQTT broker, by Eclipse Paho; remembers the newest message of each topic. */
public final class MqttTestClient implements AutoCloseable, MqttCallback {
  /** When an answer is given up; nothing that a test judges depends on it. */
  private static final long LIMIT_MS = 30_000;

  private final MqttAsyncClient client;
  private final Map<String, String> newest = new ConcurrentHashMap<>();
  private final AtomicLong received = new AtomicLong();

  /** How somebody connects. */
  public static final class Connecting {
    private final String uri;
    private final MqttConnectOptions options = new MqttConnectOptions();
    private String clientId = UUID.randomUUID().toString();

    private Connecting(String uri) {
      this.uri = uri;
      options.setMqttVersion(MqttConnectOptions.MQTT_VERSION_3_1_1);
      options.setConnectionTimeout(10);
      options.setMaxInflight(1000);
    }

    public Connecting as(String user, String password) {
      options.setUserName(user);
      options.setPassword(password.toCharArray());
      return this;
    }

    public Connecting withId(String id) {
      clientId = id;
      return this;
    }

    public Connecting withWill(String topic, String body) {
      options.setWill(topic, body.getBytes(StandardCharsets.UTF_8), 1, true);
      return this;
    }

    public Connecting by(SocketFactory sockets) {
      options.setSocketFactory(sockets);
      return this;
    }

    public MqttTestClient connect() throws MqttException {
      MqttTestClient made = new MqttTestClient(uri, clientId);
      try {
        made.client.connect(options).waitForCompletion(LIMIT_MS);
        return made;
      } catch (MqttException e) {
        made.client.close(true);
        throw e;
      }
    }
  }

  /**
   * @param uri {@code tcp://} or {@code ssl://}
   */
  public static Connecting to(String uri) {
    return new Connecting(uri);
  }

  private MqttTestClient(String uri, String clientId) throws MqttException {
    client = new MqttAsyncClient(uri, clientId, new MemoryPersistence());
    client.setCallback(this);
  }

  /**
   * @return whether the broker lets it
   */
  public boolean subscribe(String filter) throws MqttException {
    try {
      var token = client.subscribe(filter, 1);
      token.waitForCompletion(LIMIT_MS);
      return token.getGrantedQos()[0] < 128;
    } catch (MqttException e) {
      if (e.getReasonCode() == MqttException.REASON_CODE_SUBSCRIBE_FAILED) {
        return false;
      }
      throw e;
    }
  }

  /** Without waiting for the broker. */
  public void publish(String topic, String body) throws MqttException {
    publish(topic, body, 0, false);
  }

  public void publish(String topic, String body, int qos, boolean retained) throws MqttException {
    client.publish(topic, body.getBytes(StandardCharsets.UTF_8), qos, retained);
  }

  /** The newest of that topic; null: there was none. */
  public @Nullable String newest(String topic) {
    return newest.get(topic);
  }

  public long received() {
    return received.get();
  }

  public boolean isConnected() {
    return client.isConnected();
  }

  /** Waits until there is such a message. */
  public String await(String topic, Predicate<String> wanted) throws InterruptedException {
    await(() -> Optional.ofNullable(newest.get(topic)).filter(wanted).isPresent(), topic);
    return Objects.requireNonNull(newest.get(topic));
  }

  /** Waits for it, with a limit. */
  public static void await(BooleanSupplier condition, String what) throws InterruptedException {
    long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(LIMIT_MS);
    while (!condition.getAsBoolean()) {
      if (System.nanoTime() > end) {
        throw new AssertionError("not within " + LIMIT_MS + " ms: " + what);
      }
      TimeUnit.MILLISECONDS.sleep(20);
    }
  }

  /** As when its cable is pulled: the broker hears no goodbye. */
  public void vanish() throws MqttException {
    client.disconnectForcibly(0, 0, false);
    client.close(true);
  }

  @Override
  public void messageArrived(String topic, MqttMessage message) {
    newest.put(topic, new String(message.getPayload(), StandardCharsets.UTF_8));
    received.incrementAndGet();
  }

  @Override
  public void connectionLost(Throwable cause) {
    // a test asks for it
  }

  @Override
  public void deliveryComplete(IMqttDeliveryToken token) {
    // nobody asks
  }

  @Override
  public void close() throws MqttException {
    if (client.isConnected()) {
      client.disconnect(0).waitForCompletion(LIMIT_MS);
    }
    client.close(true);
  }
}
