package org.toqa.telemetry.mqtt;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.URI;
import java.nio.file.Path;
import java.util.List;
import org.eclipse.paho.client.mqttv3.MqttException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.testbed.MqttTestClient;
import org.toqa.testbed.TestCertificate;

/** The embedded broker with a certificate: by its own server, by robots, and as an external one. */
class TlsBrokerTest {
  private static final String RANGE = "toqa/v1/main/robot/r1/range";

  @TempDir private Path folder;
  private TestCertificate certificate;
  private EmbeddedBroker broker;
  private TestSite main;

  @BeforeEach
  void start() throws Exception {
    certificate = TestCertificate.in(folder, "broker");
    broker =
        EmbeddedBroker.start(
            new BrokerSettings.Embedded(
                InetAddress.getLoopbackAddress(),
                0,
                new BrokerSettings.PemFiles(certificate.file(), certificate.key())),
            new BrokerDoor(8192, 300, _ -> true));
    main = new TestSite("main");
    main.connect(broker);
  }

  @AfterEach
  void stop() {
    main.close();
    broker.close();
  }

  private MqttTestClient.Connecting as(TestCertificate trusted, String user, String password)
      throws Exception {
    return MqttTestClient.to(broker.address().uri())
        .by(trusted.trustingNoOther().getSocketFactory())
        .as(user, password);
  }

  @Test
  void readingsComeAndStatesGo() throws Exception {
    assertTrue(broker.address().shown().startsWith("mqtts://"), broker.address().shown());
    try (MqttTestClient reader = as(certificate, "main/reader", main.token).connect();
        MqttTestClient r1 = as(certificate, "main/robot/r1", main.password("r1")).connect()) {
      main.awaitOnline(reader);
      r1.publish(RANGE, "{\"stamp\":1,\"metres\":[0.5]}", 1, false);
      MqttTestClient.await(() -> !main.board.of("r1").readings().isEmpty(), "range of r1");
      assertEquals(List.of(0.5), main.board.of("r1").readings().getFirst().values());
      reader.subscribe("toqa/v1/main/robot/+/state");
      reader.await("toqa/v1/main/robot/r2/state", "IDLE"::equals);
    }
  }

  @Test
  void nobodyComesInUnencrypted() {
    String uri = broker.address().uri().replace("ssl://", "tcp://");
    assertThrows(
        MqttException.class,
        () -> MqttTestClient.to(uri).as("main/robot/r1", main.password("r1")).connect());
  }

  @Test
  void clientThatTrustsAnotherCertificateTurnsAway() throws Exception {
    TestCertificate another = TestCertificate.in(folder, "another");
    assertThrows(
        MqttException.class, () -> as(another, "main/robot/r1", main.password("r1")).connect());
  }

  @Test
  void externalBrokerIsKnownByTheCertificatesThatAreTrusted() throws Exception {
    TestSite north = new TestSite("north");
    TestSite south = new TestSite("south");
    broker.add("north", north);
    broker.add("south", south);
    TestCertificate another = TestCertificate.in(folder, "another");
    try (north;
        south;
        MqttTestClient reader = as(certificate, "north/reader", north.token).connect()) {
      north.connect(
          external(certificate.file()), broker.serverUser("north"), broker.serverPassword());
      south.connect(external(another.file()), broker.serverUser("south"), broker.serverPassword());
      north.awaitOnline(reader);
      assertTrue(north.connection().trouble().isEmpty());
      MqttTestClient.await(
          () -> south.connection().trouble().isPresent(), "what is not trusted is said");
    }
  }

  private BrokerAddress external(Path trusted) throws IOException {
    URI address = URI.create(broker.address().shown());
    return BrokerAddress.of(new BrokerSettings.External(address, null, null, trusted));
  }
}
