package org.toqa.telemetry.mqtt;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.fleet.RobotState;
import org.toqa.testbed.FaultyTcpProxy;
import org.toqa.testbed.MqttTestClient;
import org.toqa.testbed.OwnMosquitto;

/** The server at a real Mosquitto, with the users and rights that docs/telemetry.md has for it. */
@Tag("full")
class MosquittoTest {
  private static final String STATE = "toqa/v1/main/robot/r1/state";
  private static final String RANGE = "toqa/v1/main/robot/r1/range";

  @TempDir private Path folder;
  private OwnMosquitto broker;
  private FaultyTcpProxy cable;
  private TestSite main;

  @BeforeEach
  void start() throws Exception {
    broker = new OwnMosquitto(folder);
    cable = new FaultyTcpProxy(broker.port());
    main = new TestSite("main");
    main.connect(
        BrokerAddress.plain("127.0.0.1", cable.port()), OwnMosquitto.SERVER, OwnMosquitto.PASSWORD);
  }

  @AfterEach
  void stop() throws Exception {
    main.close();
    cable.close();
    broker.close();
  }

  private MqttTestClient as(String user) throws Exception {
    return MqttTestClient.to("tcp://127.0.0.1:" + broker.port())
        .as(user, OwnMosquitto.PASSWORD)
        .connect();
  }

  private List<Double> ranges() {
    return main.board.of("r1").readings().stream()
        .flatMap(reading -> reading.values().stream())
        .toList();
  }

  private void awaitState(String state) throws Exception {
    try (MqttTestClient reader = as("main/reader")) {
      reader.subscribe("toqa/v1/main/#");
      reader.await(STATE, state::equals);
    }
  }

  @Test
  void readingsComeAndStatesGoWithTheRightsOfTheDocument() throws Exception {
    awaitState("IDLE");
    try (MqttTestClient r1 = as("main/robot/r1");
        MqttTestClient r2 = as("main/robot/r2");
        MqttTestClient reader = as("main/reader")) {
      main.awaitOnline(reader);
      r2.publish(RANGE, "{\"stamp\":1,\"metres\":[9]}", 1, false);
      reader.publish(RANGE, "{\"stamp\":1,\"metres\":[8]}", 1, false);
      r1.publish(RANGE, "{\"stamp\":1,\"metres\":[0.5]}", 1, false);
      MqttTestClient.await(() -> !ranges().isEmpty(), "range of r1");
      assertEquals(List.of(0.5), ranges());
    }
  }

  @Test
  void everythingIsPublishedAnewAfterTheBrokerWasKilled() throws Exception {
    awaitState("IDLE");
    broker.kill();
    MqttTestClient.await(() -> main.connection().trouble().isPresent(), "it is away");
    main.feed.set(List.of(FeedInMemory.robot("r1", RobotState.LOST)), List.of());
    broker.startAgain();
    awaitState("LOST");
    MqttTestClient.await(() -> main.connection().trouble().isEmpty(), "it is back");
  }

  @Test
  void lastWillTellsWhenTheNetworkIsCutAndTheServerComesBack() throws Exception {
    try (MqttTestClient reader = as("main/reader")) {
      main.awaitOnline(reader);
      cable.cut();
      reader.await("toqa/v1/main/server", "offline"::equals);
      MqttTestClient.await(() -> main.connection().trouble().isPresent(), "it is away");
      cable.mend();
      reader.await("toqa/v1/main/server", "online"::equals);
    }
  }

  @Test
  void whatAServerOfThePastLeftIsCleared() throws Exception {
    awaitState("IDLE");
    main.close();
    try (MqttTestClient former = as(OwnMosquitto.SERVER)) {
      former.publish("toqa/v1/main/task/7", "DONE", 1, true);
      former.publish("toqa/v1/main/robot/r9/state", "IDLE", 1, true);
      former.subscribe("toqa/v1/main/#");
      former.await("toqa/v1/main/robot/r9/state", "IDLE"::equals);
    }
    try (MqttTestClient reader = as("main/reader")) {
      reader.subscribe("toqa/v1/main/#"); // before it is cleared, else there is nothing to see
      main.connect(
          BrokerAddress.plain("127.0.0.1", broker.port()),
          OwnMosquitto.SERVER,
          OwnMosquitto.PASSWORD);
      reader.await("toqa/v1/main/task/7", String::isEmpty);
      reader.await("toqa/v1/main/robot/r9/state", String::isEmpty);
      reader.await(STATE, "IDLE"::equals);
    }
  }

  @Test
  void wrongPasswordIsSaid() throws Exception {
    main.close();
    main.connect(BrokerAddress.plain("127.0.0.1", broker.port()), OwnMosquitto.SERVER, "wrong");
    MqttTestClient.await(() -> main.connection().trouble().isPresent(), "it is not let in");
    assertFalse(main.connection().trouble().orElseThrow().english().isBlank());
    assertTrue(ranges().isEmpty());
    assertNull(main.board.of("r1").presence());
  }
}
