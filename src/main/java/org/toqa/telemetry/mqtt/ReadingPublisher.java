package org.toqa.telemetry.mqtt;

import java.nio.charset.StandardCharsets;
import org.eclipse.paho.client.mqttv3.MqttAsyncClient;
import org.eclipse.paho.client.mqttv3.MqttConnectOptions;
import org.eclipse.paho.client.mqttv3.MqttException;
import org.eclipse.paho.client.mqttv3.persist.MemoryPersistence;
import org.toqa.telemetry.Telemetry;

/**
 * A robot's own end of MQTT, as its program would have it: says that it is connected, with the last
 * will that it is not, and publishes readings. Connects again by itself. Any thread may call it.
 */
public final class ReadingPublisher implements AutoCloseable {
  private static final long LIMIT_MILLIS = 10_000;
  private static final String CONNECTION = "connection";

  private final MqttAsyncClient client;
  private final String topics;

  private ReadingPublisher(MqttAsyncClient client, String topics) {
    this.client = client;
    this.topics = topics;
  }

  /**
   * @param broker one without encryption
   * @param login of the robot
   * @throws IllegalStateException the broker does not let it; the message says why
   */
  public static ReadingPublisher connect(Telemetry.BrokerPlace broker, Telemetry.Login login) {
    String topics = "toqa/v1/" + login.user() + "/";
    MqttConnectOptions options = new MqttConnectOptions();
    options.setMqttVersion(MqttConnectOptions.MQTT_VERSION_3_1_1);
    options.setUserName(login.user());
    options.setPassword(login.password().toCharArray());
    options.setAutomaticReconnect(true);
    options.setWill(topics + CONNECTION, bytes("offline"), 1, true);
    try {
      MqttAsyncClient client =
          new MqttAsyncClient(
              broker.address().replaceFirst("^mqtt:", "tcp:"),
              login.user().replace('/', '-'),
              new MemoryPersistence());
      client.connect(options).waitForCompletion(LIMIT_MILLIS);
      client.publish(topics + CONNECTION, bytes("online"), 1, true);
      return new ReadingPublisher(client, topics);
    } catch (MqttException e) {
      throw new IllegalStateException(
          login.user() + " cannot publish at " + broker.address() + ": " + e.getMessage(), e);
    }
  }

  private static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
  }

  /** Publishes a reading; nothing while the broker is away. */
  public void publish(String reading, String json) {
    try {
      client.publish(topics + reading, bytes(json), 0, false);
    } catch (MqttException brokerIsAway) {
      // the next reading comes soon
    }
  }

  @Override
  public void close() {
    try {
      client.disconnectForcibly(0, LIMIT_MILLIS);
      client.close(true);
    } catch (MqttException e) {
      throw new IllegalStateException(e);
    }
  }
}
