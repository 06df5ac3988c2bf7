package org.toqa.telemetry.mqtt;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.URI;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalLong;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import org.eclipse.paho.client.mqttv3.MqttException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.toqa.accounts.Secret;
import org.toqa.fleet.RobotState;
import org.toqa.telemetry.Refusal;
import org.toqa.testbed.MqttTestClient;

/** The embedded broker with two sites, and robots and programs at it by Eclipse Paho. */
@Tag("full")
class EmbeddedBrokerTest {
  private static final String RANGE = "{\"stamp\":1,\"metres\":[0.5,1.25]}";

  /** So many a user may have. */
  private static final int CONNECTIONS = 20;

  private EmbeddedBroker broker;
  private TestSite main;
  private TestSite north;
  private MqttTestClient reader;

  @BeforeEach
  void start() throws Exception {
    broker = start(0);
    main = new TestSite("main");
    north = new TestSite("north");
    main.connect(broker);
    north.connect(broker);
    reader = main.reader(broker);
    main.awaitOnline(reader);
  }

  private static EmbeddedBroker start(int port) throws IOException {
    return start(port, new BrokerDoor(8192, 300, _ -> true));
  }

  private static EmbeddedBroker start(int port, BrokerDoor door) throws IOException {
    return EmbeddedBroker.start(
        new BrokerSettings.Embedded(InetAddress.getLoopbackAddress(), port, null), door);
  }

  @AfterEach
  void stop() throws Exception {
    reader.close();
    main.close();
    north.close();
    broker.close();
  }

  private static List<Double> range(TestSite site, String robot) {
    return site.board.of(robot).readings().stream()
        .filter(reading -> reading.name().equals("range"))
        .map(reading -> reading.values())
        .findFirst()
        .orElse(List.of());
  }

  @Test
  void serverHearsWhatARobotPublishes() throws Exception {
    try (MqttTestClient r1 = main.robot(broker, "r1")) {
      r1.publish("toqa/v1/main/robot/r1/range", RANGE, 1, false);
      MqttTestClient.await(() -> range(main, "r1").equals(List.of(0.5, 1.25)), "range of r1");
    }
  }

  @Test
  void robotPublishesAndReadsNothingButItsOwn() throws Exception {
    reader.subscribe("toqa/v1/main/#");
    try (MqttTestClient r1 = main.robot(broker, "r1")) {
      assertFalse(r1.subscribe("toqa/v1/main/robot/r2/state"));
      assertFalse(r1.subscribe("toqa/v1/main/#"));
      assertFalse(r1.subscribe("#"));
      assertFalse(r1.subscribe("toqa/v1/main/robot/+/range"));
      assertFalse(r1.subscribe("$share/g/toqa/v1/main/robot/r2/range"));
      assertTrue(r1.subscribe("toqa/v1/main/robot/r1/#"));
      for (String topic :
          List.of(
              "toqa/v1/main/robot/r2/range",
              "toqa/v1/main/robot/r1/state",
              "toqa/v1/main/robot/r1/a/b",
              "toqa/v1/main/server",
              "toqa/v1/main/task/1",
              "toqa/v1/north/robot/r1/range")) {
        r1.publish(topic, RANGE);
      }
      r1.publish("toqa/v1/main/robot/r1/range", RANGE); // comes after those
      reader.await("toqa/v1/main/robot/r1/range", RANGE::equals);
    }
    assertEquals("IDLE", reader.newest("toqa/v1/main/robot/r1/state"));
    assertEquals("online", reader.newest("toqa/v1/main/server"));
    assertNull(reader.newest("toqa/v1/main/robot/r2/range"));
    assertNull(reader.newest("toqa/v1/main/robot/r1/a/b"));
    assertNull(reader.newest("toqa/v1/main/task/1"));
    assertEquals(List.of(), range(main, "r2"));
    assertEquals(List.of(), range(north, "r1"));
  }

  @Test
  void nobodyComesInWithoutHisPassword() {
    assertRefused("main/robot/r1", Secret.random());
    assertRefused("main/robot/r1", "");
    assertRefused("main/robot/r1", main.password("r2"));
    assertRefused("main/robot/r3", main.password("r1"));
    assertRefused("main/reader", Secret.random());
    assertRefused("main/reader", north.token);
    assertRefused("north/robot/r1", main.password("r1"));
    assertRefused("main/server", Secret.random());
    assertRefused("south/reader", main.token);
    assertRefused("r1", main.password("r1"));
    assertThrows(MqttException.class, () -> MqttTestClient.to(broker.address().uri()).connect());
  }

  private void assertRefused(String user, String password) {
    assertThrows(
        MqttException.class,
        () -> MqttTestClient.to(broker.address().uri()).as(user, password).connect(),
        user);
  }

  @Test
  void readerSeesTheRetainedStatesOfItsSiteAlone() throws Exception {
    reader.subscribe("toqa/v1/main/#");
    assertEquals("IDLE", reader.await("toqa/v1/main/robot/r2/state", any -> true));
    assertFalse(reader.subscribe("toqa/v1/north/#"));
    assertFalse(reader.subscribe("toqa/v1/+/robot/r1/state"));
    assertFalse(reader.subscribe("#"));
    assertFalse(reader.subscribe("$SYS/#"));
    reader.publish("toqa/v1/main/robot/r1/state", "forged", 0, true);
    main.feed.set(List.of(FeedInMemory.robot("r2", RobotState.LOST)), List.of());
    assertEquals("LOST", reader.await("toqa/v1/main/robot/r2/state", "LOST"::equals));
    assertEquals("", reader.await("toqa/v1/main/robot/r1/state", String::isEmpty), "r1 is no more");
    try (MqttTestClient later = main.reader(broker)) {
      later.subscribe("toqa/v1/main/robot/+/state");
      later.await("toqa/v1/main/robot/r2/state", "LOST"::equals);
      assertNull(later.newest("toqa/v1/main/robot/r1/state"), "nothing is kept of it");
    }
  }

  @Test
  void lastWillIsTheRobotsOwnConnection() throws Exception {
    String connection = "toqa/v1/main/robot/r1/connection";
    MqttTestClient r1 =
        MqttTestClient.to(broker.address().uri())
            .as("main/robot/r1", main.password("r1"))
            .withWill(connection, "offline")
            .connect();
    r1.publish(connection, "online", 1, true);
    MqttTestClient.await(() -> main.isOnline("r1"), "r1 is online");
    r1.vanish();
    MqttTestClient.await(() -> !main.isOnline("r1"), "r1 is offline");
  }

  @Test
  void lastWillOnAnothersTopicKeepsItsUserOut() {
    for (String topic :
        List.of(
            "toqa/v1/main/robot/r2/range",
            "toqa/v1/main/robot/r2/connection",
            "toqa/v1/main/robot/r1/state",
            "toqa/v1/north/robot/r1/connection",
            "toqa/v1/main/server")) {
      assertThrows(
          MqttException.class,
          () ->
              MqttTestClient.to(broker.address().uri())
                  .as("main/robot/r1", main.password("r1"))
                  .withWill(topic, "offline")
                  .connect(),
          topic);
    }
  }

  @Test
  void brokerKeepsNoReadingForLater() throws Exception {
    try (MqttTestClient r1 = main.robot(broker, "r1")) {
      r1.publish("toqa/v1/main/robot/r1/range", RANGE, 1, true);
      MqttTestClient.await(() -> !range(main, "r1").isEmpty(), "range of r1");
      r1.publish("toqa/v1/main/robot/r1/connection", "online", 1, true);
      MqttTestClient.await(() -> main.board.of("r1").presence() != null, "connection of r1");
    }
    try (MqttTestClient later = main.reader(broker)) {
      later.subscribe("toqa/v1/main/robot/r1/#");
      later.await("toqa/v1/main/robot/r1/connection", "online"::equals);
      later.await("toqa/v1/main/robot/r1/state", "IDLE"::equals);
      assertNull(later.newest("toqa/v1/main/robot/r1/range"));
    }
  }

  @Test
  void clientIdOfAnotherIsNotTakenOver() throws Exception {
    try (MqttTestClient r1 =
        MqttTestClient.to(broker.address().uri())
            .withId("arm")
            .as("main/robot/r1", main.password("r1"))
            .connect()) {
      assertThrows(
          MqttException.class,
          () ->
              MqttTestClient.to(broker.address().uri())
                  .withId("arm")
                  .as("main/robot/r2", main.password("r2"))
                  .connect());
      assertTrue(r1.isConnected());
    }
  }

  @Test
  void connectionEndsWithItsPasswordOrToken() throws Exception {
    try (MqttTestClient r1 = main.robot(broker, "r1");
        MqttTestClient r2 = main.robot(broker, "r2")) {
      main.passwords.put("r1", Secret.random());
      main.isTokenValid = false;
      MqttTestClient.await(() -> !r1.isConnected() && !reader.isConnected(), "both are sent away");
      assertTrue(r2.isConnected());
    }
  }

  /** By whatever names. */
  @Test
  void oneTokenOpensSoManyConnections() throws Exception {
    List<MqttTestClient> clients = new ArrayList<>();
    for (int i = 1; i < CONNECTIONS; i++) { // beside the reader
      clients.add(
          MqttTestClient.to(broker.address().uri()).as("main/reader/a" + i, main.token).connect());
    }

    assertRefused("main/reader/another", main.token);
    clients.add(north.reader(broker)); // another account
    clients.add(main.robot(broker, "r1"));
    for (MqttTestClient client : clients) {
      client.close();
    }
  }

  @Test
  void whoFindsNoPlaceIsSentAwayBeforeHeSaysWhoHeIs() throws Exception {
    BrokerDoor door = new BrokerDoor(1, 1, _ -> true);
    InetAddress here = InetAddress.getLoopbackAddress();
    while (door.tryEnter(here)) {
      // as connections do
    }
    try (EmbeddedBroker full = start(0, door)) {
      full.add("main", main);
      URI uri = URI.create(full.address().uri());
      try (Socket late = new Socket(uri.getHost(), uri.getPort())) {
        late.setSoTimeout(5_000); // who may come in has longer to say who he is
        assertEquals(-1, late.getInputStream().read());
      }

      door.leave(here);
      MqttTestClient.await(() -> canRead(full), "there is a place");
      MqttTestClient.await(() -> canRead(full), "there is a place again");
    }
  }

  private boolean canRead(EmbeddedBroker other) {
    try (MqttTestClient client = main.reader(other)) {
      return client.isConnected();
    } catch (Exception e) {
      return false;
    }
  }

  /** Else its user would not be let in again before the next start. */
  @Test
  @Timeout(120)
  void whoDropsItsConnectionDuringItsLoginIsForgotten() throws Exception {
    HeldLogins users = new HeldLogins();
    broker.add("south", users);
    for (int i = 0; i < 3 * CONNECTIONS; i++) {
      recheckLater();
      users.hold("drop-" + i);
      dropDuringLogin(users, "drop-" + i);
    }
    long before = presentCount();

    for (int i = 0; i < CONNECTIONS; i++) {
      recheckLater();
      users.clients.add(
          MqttTestClient.to(broker.address().uri()).as("south/robot/r1", "any").connect());
      long inAll = before + users.clients.size();
      MqttTestClient.await(() -> presentCount() == inAll, inAll + " are present");
    }
    recheckLater();
    assertRefused("south/robot/r1", "any"); // who is connected still counts
    for (MqttTestClient client : users.clients) {
      client.close();
    }
  }

  private long presentCount() {
    return broker.present().stream().filter(client -> !client.startsWith("drop-")).count();
  }

  private void recheckLater() {
    broker.recheck(System.nanoTime() + Duration.ofSeconds(31).toNanos());
  }

  private void dropDuringLogin(HeldLogins users, String password) throws Exception {
    try (Socket socket = new Socket()) {
      URI uri = URI.create(broker.address().uri());
      socket.connect(new InetSocketAddress(uri.getHost(), uri.getPort()));
      socket.setSoLinger(true, 0);
      socket.getOutputStream().write(connectPacket(password, "south/robot/r1", password));
      assertTrue(users.held.tryAcquire(20, TimeUnit.SECONDS), "it is not let in any more");
    }
    users.released.release();
  }

  /** CONNECT of MQTT 3.1.1, section 3.1, with a clean session. */
  private static byte[] connectPacket(String clientId, String user, String password)
      throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    DataOutputStream rest = new DataOutputStream(bytes);
    rest.writeUTF("MQTT");
    rest.writeByte(4); // the protocol's level
    rest.writeByte(0b1100_0010); // user, password, clean session
    rest.writeShort(60);
    rest.writeUTF(clientId);
    rest.writeUTF(user);
    rest.writeUTF(password);
    ByteArrayOutputStream packet = new ByteArrayOutputStream();
    packet.write(0x10);
    packet.write(bytes.size());
    bytes.writeTo(packet);
    return packet.toByteArray();
  }

  /** Takes any password, one of them late. */
  private static final class HeldLogins implements EmbeddedBroker.SiteUsers {
    final List<MqttTestClient> clients = new ArrayList<>();
    final Semaphore held = new Semaphore(0);
    final Semaphore released = new Semaphore(0);
    private final AtomicReference<String> late = new AtomicReference<>("");

    void hold(String password) {
      late.set(password);
    }

    @Override
    public boolean isRobot(String name, String password) {
      if (password.equals(late.get())) {
        late.set("");
        held.release();
        released.acquireUninterruptibly();
      }
      return true;
    }

    @Override
    public OptionalLong reader(String token) {
      return OptionalLong.empty();
    }
  }

  @Test
  void floodOfOneRobotDisturbsNoOther() throws Exception {
    try (MqttTestClient r1 = main.robot(broker, "r1");
        MqttTestClient r2 = main.robot(broker, "r2")) {
      for (int i = 0; i < 1000; i++) {
        r1.publish("toqa/v1/main/robot/r1/range", "{\"stamp\":%d,\"metres\":[1]}".formatted(i));
      }
      r2.publish("toqa/v1/main/robot/r2/range", RANGE, 1, false);
      MqttTestClient.await(() -> !range(main, "r2").isEmpty(), "range of r2");
      MqttTestClient.await(
          () -> main.board.of("r1").refusals().getOrDefault(Refusal.TOO_OFTEN, 0L) > 0,
          "what is passed over is counted");
      MqttTestClient.await(
          () -> main.board.of("r1").readings().stream().anyMatch(reading -> reading.stamp() == 999),
          "the newest wins");
    }
  }

  @Test
  void serverConnectsAgainAndPublishesAnewAfterTheBrokersRestart() throws Exception {
    int port = Integer.parseInt(broker.address().uri().replaceFirst(".*:", ""));
    broker.close();
    MqttTestClient.await(
        () -> main.connection().trouble().isPresent(), "the server sees that it is away");
    broker = start(port);
    assertTrue(broker.address().uri().endsWith(":" + port));
    main.close(); // each start has another password of the server's own
    main.connect(broker);
    try (MqttTestClient later = main.reader(broker)) {
      later.subscribe("toqa/v1/main/#");
      later.await("toqa/v1/main/robot/r1/state", "IDLE"::equals);
      assertNotNull(later.await("toqa/v1/main/server", "online"::equals));
    }
    assertTrue(main.connection().trouble().isEmpty());
  }

  @Test
  void serverSaysGoodbye() throws Exception {
    main.close();
    assertEquals("offline", reader.await("toqa/v1/main/server", "offline"::equals));
  }

  @Test
  void takenPortStopsTheStartWithASentence() {
    int port = Integer.parseInt(broker.address().uri().replaceFirst(".*:", ""));
    IOException e = assertThrows(IOException.class, () -> start(port));
    assertTrue(String.valueOf(e.getMessage()).contains("mqtt.port"), e.getMessage());
  }
}
