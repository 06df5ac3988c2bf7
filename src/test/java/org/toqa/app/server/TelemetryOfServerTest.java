package org.toqa.app.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.URI;
import java.nio.file.Path;
import java.util.EnumMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.stream.StreamSupport;
import org.eclipse.paho.client.mqttv3.MqttException;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.accounts.Secret;
import org.toqa.app.command.StopSignal;
import org.toqa.app.config.Configuration;
import org.toqa.app.config.Setting;
import org.toqa.app.config.SettingSource;
import org.toqa.testbed.ApiClient;
import org.toqa.testbed.MqttTestClient;
import org.toqa.web.TestClient;
import org.toqa.web.WebTestServer;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** A whole server with its embedded MQTT broker: what comes and goes over it. */
@Tag("full")
class TelemetryOfServerTest {
  private static final Path WEBAPP = Path.of("target/webapp").toAbsolutePath();
  private static final Path MAPS = Path.of("maps").toAbsolutePath();
  private static final JsonMapper JSON = JsonMapper.builder().build();

  @TempDir private Path folder;

  /** What a test does with a running server. */
  @FunctionalInterface
  private interface Use {
    void use(ApiClient api) throws Exception;
  }

  @Test
  void wholeLifeOfATaskIsSeenByAProgramWithAToken() throws Exception {
    run(
        "embedded",
        api -> {
          try (MqttTestClient reader = reader(api)) {
            reader.subscribe("toqa/v1/main/#");
            reader.await("toqa/v1/main/robot/r1/state", state -> state.contains("\"IDLE\""));
            // a snapshot is published each half second: it is on its way for several of these
            long task = order(api, "Store A");
            String topic = "toqa/v1/main/task/" + task;
            Set<String> states = new LinkedHashSet<>();
            reader.await(
                topic,
                body -> {
                  states.add(JSON.readTree(body).get("state").asString());
                  return states.contains("DONE");
                });
            assertTrue(
                states.containsAll(Set.of("TO_OBJECT", "CARRYING", "DONE")), states::toString);
            assertEquals(
                "Box", JSON.readTree(reader.await(topic, any -> true)).get("name").asString());
            try (MqttTestClient later = reader(api)) {
              later.subscribe(topic);
              later.await(topic, body -> body.contains("\"DONE\""));
            }
            assertTrue(api.delete("tasks/" + task).isAccepted());
            reader.await(topic, String::isEmpty);
            assertThrows(
                MqttException.class, () -> reader(api, api.token()).close(), "a session's secret");
          }
        });
  }

  /** It reads at the broker by then: what nobody reads there is kept for nobody. */
  private static void awaitServer(ApiClient api) throws Exception {
    try (MqttTestClient reader = reader(api)) {
      reader.subscribe("toqa/v1/main/#");
      reader.await("toqa/v1/main/robot/r1/state", any -> true);
    }
  }

  @Test
  void readingsAreShownAndAlertBeyondTheirLimits() throws Exception {
    run(
        "embedded",
        api -> {
          awaitServer(api);
          JsonNode login = api.post("robots/r1/mqtt-password", Map.of());
          assertEquals("main/robot/r1", login.get("user").asString());
          try (MqttTestClient robot = robot(login)) {
            robot.publish(
                "toqa/v1/main/robot/r1/range", "{\"stamp\":1,\"metres\":[0.2,2]}", 1, false);
            MqttTestClient.await(() -> !readings(api).isEmpty(), "the reading");
            JsonNode range = readings(api).get(0);
            assertEquals("range", range.get("name").asString());
            assertEquals(0.2, range.get("values").get(0).asDouble());
            assertTrue(api.put("robots/r1/limits/range", Map.of("low", 0.3)).isAccepted());
            awaitAlert(api, "Its reading range is 0.2 m, below its limit of 0.3 m.");
            robot.publish(
                "toqa/v1/main/robot/r1/range", "{\"stamp\":2,\"metres\":[0.4,2]}", 1, false);
            awaitAlert(api, null);
            assertEquals(
                422, api.put("robots/r1/limits/range", Map.of("low", 3, "high", 2)).status());
            assertEquals(422, api.put("robots/r1/limits/state", Map.of("low", 3)).status());
            assertEquals(404, api.put("robots/r9/limits/range", Map.of("low", 3)).status());

            JsonNode next = api.post("robots/r1/mqtt-password", Map.of());
            MqttTestClient.await(() -> !robot.isConnected(), "the old password ends");
            assertThrows(MqttException.class, () -> robot(login).close());
            robot(next).close();
          }
        });
    run("embedded", api -> assertEquals(0.3, limits(api).get(0).get("low").asDouble()));
  }

  @Test
  void floodLiesAndWrongPasswordsDisturbNoTask() throws Exception {
    run(
        "embedded",
        api -> {
          JsonNode login = api.post("robots/r1/mqtt-password", Map.of());
          AtomicBoolean isOver = new AtomicBoolean();
          try (MqttTestClient robot = robot(login);
              ExecutorService attackers = Executors.newVirtualThreadPerTaskExecutor()) {
            try {
              attackers.execute(() -> flood(robot, isOver));
              attackers.execute(() -> guess(login, isOver));
              long task = order(api);
              awaitState(api, "DRIVING");
              assertTrue(api.replyTo("fleet/pause", Map.of()).isAccepted());
              awaitState(api, "HOLDING");
              assertTrue(api.replyTo("fleet/resume", Map.of()).isAccepted());
              awaitDone(api, task);
              MqttTestClient.await(
                  () -> passedOver(api, "out-of-bounds") > 0 && passedOver(api, "too-often") > 0,
                  "lies and flood are counted");
              assertTrue(readings(api).isEmpty());
            } finally {
              isOver.set(true);
              robot.vanish(); // a goodbye would wait behind the flood
            }
          }
        });
  }

  /** As fast as it is taken, and each a lie. */
  private static void flood(MqttTestClient robot, AtomicBoolean isOver) {
    while (!isOver.get() && robot.isConnected()) {
      try {
        robot.publish("toqa/v1/main/robot/r1/range", "{\"stamp\":1,\"metres\":[-5]}");
      } catch (MqttException e) {
        Thread.onSpinWait(); // too many are in flight
      }
    }
  }

  private static void guess(JsonNode login, AtomicBoolean isOver) {
    while (!isOver.get()) {
      assertThrows(
          MqttException.class,
          () ->
              MqttTestClient.to(login.get("broker").asString().replace("mqtt:", "tcp:"))
                  .as(login.get("user").asString(), Secret.random())
                  .connect()
                  .close());
    }
  }

  private static long passedOver(ApiClient api, String reason) {
    try {
      return api.get("robots/r1/readings").get("passedOver").path(reason).asLong(0);
    } catch (Exception e) {
      throw new AssertionError(e);
    }
  }

  private static long order(ApiClient api) throws Exception {
    return order(api, "Goods-in 2");
  }

  private static long order(ApiClient api, String goal) throws Exception {
    return api.post(
            "tasks",
            Map.of(
                "name",
                "Box",
                "load",
                2,
                "start",
                Map.of("station", "Goods-in 1"),
                "goal",
                Map.of("station", goal)))
        .get("id")
        .asLong();
  }

  /** Of the robot. */
  private static void awaitState(ApiClient api, String state) throws Exception {
    api.awaitSnapshot(
        snapshot -> snapshot.get("robots").get(0).get("state").asString().equals(state));
  }

  private static void awaitDone(ApiClient api, long task) throws Exception {
    api.awaitSnapshot(
        snapshot ->
            StreamSupport.stream(snapshot.get("tasks").spliterator(), false)
                .anyMatch(
                    t -> t.get("id").asLong() == task && t.get("state").asString().equals("DONE")));
  }

  @Test
  void withoutConfigurationThereIsNoMqtt() throws Exception {
    run(
        null,
        api -> {
          assertEquals(404, api.replyTo("robots/r1/mqtt-password", Map.of()).status());
          assertFalse(
              StreamSupport.stream(api.get("robots").spliterator(), false)
                  .anyMatch(robot -> robot.hasNonNull("alert")));
        });
  }

  @Test
  void brokerThatIsAwayIsSaidAndDisturbsNothing() throws Exception {
    run(
        "mqtt://127.0.0.1:9",
        api -> {
          api.awaitSnapshot(
              snapshot ->
                  StreamSupport.stream(snapshot.get("alerts").spliterator(), false)
                      .anyMatch(alert -> alert.asString().contains("mqtt://127.0.0.1:9")));
          assertEquals(409, api.replyTo("robots/r1/mqtt-password", Map.of()).status());
          awaitDone(api, order(api));
        });
  }

  private static JsonNode readings(ApiClient api) {
    try {
      return api.get("robots/r1/readings").get("readings");
    } catch (Exception e) {
      throw new AssertionError(e);
    }
  }

  private static JsonNode limits(ApiClient api) throws Exception {
    return api.get("robots/r1/readings").get("limits");
  }

  private static void awaitAlert(ApiClient api, @Nullable String alert) throws Exception {
    api.awaitSnapshot(
        snapshot -> {
          JsonNode now = snapshot.get("robots").get(0).get("alert");
          return alert == null ? now.isNull() : alert.equals(now.asString());
        });
  }

  private static MqttTestClient robot(JsonNode login) throws MqttException {
    return MqttTestClient.to(login.get("broker").asString().replace("mqtt:", "tcp:"))
        .as(login.get("user").asString(), login.get("password").asString())
        .connect();
  }

  private static MqttTestClient reader(ApiClient api) throws Exception {
    return reader(api, apiToken(api));
  }

  private static MqttTestClient reader(ApiClient api, String password) throws Exception {
    String broker = api.get("robots/r1/readings").get("broker").asString();
    return MqttTestClient.to(broker.replace("mqtt:", "tcp:"))
        .as("main/reader/dashboard", password)
        .connect();
  }

  private static String apiToken(ApiClient api) throws Exception {
    long user = api.get("users").get(0).get("id").asLong();
    try (TestClient browser = TestClient.signedIn(api.root(), "Max")) {
      String made =
          browser
              .postJson(
                  "api/v1/users/" + user + "/tokens",
                  "{\"name\":\"dashboard\",\"days\":1,\"scopes\":[\"read\"],\"password\":\"%s\"}"
                      .formatted(WebTestServer.PASSWORD))
              .body();
      return JSON.readTree(made).get("token").asString();
    }
  }

  private void run(@Nullable String broker, Use use) throws Exception {
    Map<Setting, @Nullable String> options = new EnumMap<>(Setting.class);
    options.put(Setting.PORT, "0");
    options.put(Setting.DATA, folder.toString());
    options.put(Setting.MAP, MAPS.resolve("lab.yaml").toString());
    options.put(Setting.SIMULATE, "1");
    options.put(Setting.SPEED, "20");
    options.put(Setting.MANAGER, "Max:" + WebTestServer.PASSWORD_HASH);
    options.put(Setting.MQTT_BROKER, broker);
    options.put(Setting.MQTT_PORT, "0");
    options.put(Setting.LOG_LEVEL, "ERROR");
    Configuration configuration =
        Configuration.of(MAPS.resolve("lab.yaml"), List.of(SettingSource.fromCommandLine(options)));
    ServerOperation operation =
        (FleetServer _, URI address, StopSignal _) -> {
          try (ApiClient api = new ApiClient(address, "Max", WebTestServer.PASSWORD)) {
            use.use(api);
          }
          return 0;
        };
    try (StopSignal stop = new StopSignal()) {
      assertEquals(0, operation.runWith(configuration, WEBAPP, stop));
    }
  }
}
