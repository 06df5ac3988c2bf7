package org.toqa.link;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.link.message.AgentMessage.Ack;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.AgentMessage.State;
import org.toqa.link.message.ServerMessage.Ping;
import org.toqa.link.trust.IdentityFile;
import org.toqa.link.trust.LinkTls;
import org.toqa.testbed.LinkRecorder;

/** The server's end of the link, against a robot that the test plays by hand. */
@Timeout(30)
class TcpRobotLinkTest {

  private static final String HELLO =
      """
      {"type":"hello","version":1,"robot":"r1","maxLoad":5.0,"maxSpeed":0.5,"footprint":0.255,\
      "localised":true,"pose":{"x":1.5,"y":2.25,"theta":0.5},"mode":"IDLE","task":null,"phase":0,\
      "role":"ALONE","drive":0,"segment":0,"released":0,"lastSeq":19,"done":null}""";

  @TempDir private Path keys;
  private ServerSocket robot;
  private final LinkRecorder heard = new LinkRecorder();
  private RobotLink link;

  /** What the link told, in its order. */
  @BeforeEach
  void open() throws IOException {
    robot = new ServerSocket(0, 10, InetAddress.getLoopbackAddress());
    robot.setSoTimeout(10_000);
    link = open("127.0.0.1", robot.getLocalPort(), heard);
  }

  @AfterEach
  void close() throws IOException {
    link.close();
    robot.close();
  }

  @Test
  void helloConnectsAndMessagesGoBothWays() throws Exception {
    try (Socket socket = greet()) {
      link.send(new Ping(3));
      assertEquals("{\"type\":\"ping\",\"seq\":3}", line(socket));
      say(socket, "{\"type\":\"ack\",\"seq\":3}");
      assertEquals(new Ack(3), heard.next());
    }
  }

  /** Also where nothing else comes that can be understood. */
  @Test
  void whatIsWrongWithALineIsTold() throws Exception {
    try (Socket socket = greet()) {
      say(
          socket,
          """
          {"type":"state","stamp":0,"localised":true,"pose":{"x":1,"y":1,"theta":0},\
          "twist":{"v":0,"w":0},"mode":"IDLE","task":null,"phase":0,"role":"ALONE","drive":0,\
          "segment":0,"released":0,"battery":1.7,"ranges":[],"obstacles":[],"errors":[]}""");
      assertEquals("The battery of the state is not from 0 to 1.", heard.nextFault());
      assertTrue(heard.isEmpty());
    }
  }

  @Test
  void linkConnectsAgainByItself() throws Exception {
    greet().close();
    assertEquals(
        new LinkRecorder.End(
            "r1 closed the connection. If it does not come back, look at its daemon’s log."),
        heard.next());

    try (Socket socket = greet()) {
      say(socket, "{\"type\":\"ack\",\"seq\":4}");
      assertEquals(new Ack(4), heard.next());
    }
  }

  @Test
  void aRobotWhoseWordSurprisesTheServerIsConnectedAnew() throws Exception {
    heard.failNext();
    try (Socket socket = greet()) {
      say(socket, "{\"type\":\"ack\",\"seq\":4}");
      assertEquals(
          "The server ended the connection to r1 by a fault of its own, and connects again. Its log"
              + " says more.",
          heard.await(LinkRecorder.End.class).sentence());
    }

    try (Socket socket = greet()) {
      say(socket, "{\"type\":\"ack\",\"seq\":5}");
      assertEquals(new Ack(5), heard.next());
    }
  }

  @Test
  void whatIsSentWithoutAConnectionIsDropped() throws Exception {
    link.send(new Ping(1));
    try (Socket socket = greet()) {
      link.send(new Ping(2));
      assertEquals("{\"type\":\"ping\",\"seq\":2}", line(socket));
    }
  }

  @Test
  void anotherRobotIsRefused() throws Exception {
    try (Socket socket = robot.accept()) {
      say(socket, HELLO.replace("\"r1\"", "\"r2\""));

      assertEquals(
          "The robot at 127.0.0.1:%d has another name than r1. Correct the address or the name."
              .formatted(robot.getLocalPort()),
          heard.await(LinkRecorder.Refusal.class).sentence());
      assertNull(line(socket), "the connection is closed");
    }
  }

  /** It waits for who connects to show who he is, and says nothing before. */
  @Test
  void aPairedDaemonThatIsSpokenToWithoutACodeIsToldWithWhatToDo() throws Exception {
    try (Socket _ = robot.accept()) {
      assertEquals(
          "r1 at 127.0.0.1:%d says nothing. If it is paired, enter the code that it shows."
              .formatted(robot.getLocalPort()),
          heard.await(LinkRecorder.Refusal.class).sentence());
    }
  }

  @Test
  void anotherVersionIsRefused() throws Exception {
    try (Socket socket = robot.accept()) {
      say(socket, HELLO.replace("\"version\":1", "\"version\":2"));

      assertEquals(
          "r1 speaks version 2 of the robot link, this server version 1. Update the older one.",
          heard.await(LinkRecorder.End.class).sentence());
    }
  }

  @Test
  void peerThatDoesNotSayHelloIsRefused() throws Exception {
    try (Socket socket = robot.accept()) {
      say(socket, "{\"type\":\"ack\",\"seq\":3}");

      assertEquals(
          "What answers at 127.0.0.1:%d is not r1: it does not begin as a robot does. Check address and port."
              .formatted(robot.getLocalPort()),
          heard.await(LinkRecorder.End.class).sentence());
    }
  }

  @Test
  void robotIsToldWhatItsHelloLacks() throws Exception {
    try (Socket socket = robot.accept()) {
      say(socket, HELLO.replace("\"role\":\"ALONE\"", "\"role\":null"));

      assertEquals(
          "The first line of r1 at 127.0.0.1:%d cannot be understood: The field \"role\" of the hello is missing or of the wrong kind. Correct its program."
              .formatted(robot.getLocalPort()),
          heard.await(LinkRecorder.End.class).sentence());
      assertNull(line(socket), "the connection is closed");
    }
  }

  @Test
  void whatIsNoRobotIsNotCalledSilent() throws Exception {
    try (Socket socket = robot.accept()) {
      say(socket, "SSH-2.0-OpenSSH_9.9");
      socket.shutdownOutput();

      String why = heard.await(LinkRecorder.End.class).sentence();
      assertTrue(why.endsWith("it does not begin as a robot does. Check address and port."), why);
    }
  }

  @Test
  void silentPeerIsLeftAfterFiveSeconds() throws Exception {
    try (Socket socket = greet()) {
      assertEquals(
          new LinkRecorder.End(
              "r1 has said nothing for 5 s. If it does not come back, check that it is switched on"
                  + " and in the network."),
          heard.next());
      assertNull(line(socket), "the connection is closed");
    }
  }

  @Test
  void lineThatCannotBeReadIsPassedOver() throws Exception {
    try (Socket socket = greet()) {
      say(socket, "{\"type\":\"song\"}");
      say(socket, "x".repeat(1_000_000));
      say(socket, "\u0000\u0007garbage");
      say(socket, "{\"type\":\"ack\",\"seq\":5}");

      assertEquals(new Ack(5), heard.next());
    }
  }

  @Test
  void robotThatDoesNotReadIsLeftAndTheCallerNeverWaits() throws Exception {
    try (Socket _ = greet()) {
      // the socket's buffers and the queue of 1000 lines fill
      for (int i = 0; i < 1_000_000 && heard.isEmpty(); i++) {
        link.send(new Ping(i));
      }

      assertEquals(
          new LinkRecorder.End("r1 does not take what it is told. Look at its daemon’s log."),
          heard.next());
    }
  }

  @Test
  void robotThatIsNotThereIsToldOnceAndTriedAgain() throws Exception {
    int port = robot.getLocalPort();
    link.close();
    robot.close();
    LinkRecorder another = new LinkRecorder();
    try (RobotLink _ = open("127.0.0.1", port, another)) {
      String sentence = another.await(LinkRecorder.End.class).sentence();
      assertTrue(
          sentence.startsWith("No program accepts connections at 127.0.0.1:" + port), sentence);

      try (ServerSocket late = new ServerSocket(port, 10, InetAddress.getLoopbackAddress());
          Socket socket = late.accept()) {
        say(socket, HELLO);
        assertTrue(another.next() instanceof Hello, "no second complaint comes before it");
      }
    }
  }

  @Test
  void robotOnAnotherMachineIsRefusedUnlessAllowed() throws Exception {
    LinkRecorder another = new LinkRecorder();
    try (RobotLink _ = open("192.0.2.1", 7275, another)) {
      assertEquals(
          "r1 is on another machine (192.0.2.1:7275) and is not paired: enter the code that it"
              + " shows.",
          another.await(LinkRecorder.Refusal.class).sentence());
    }
  }

  @Test
  void closedLinkTellsNothingMoreAndDoesNotComeBack() throws Exception {
    try (Socket socket = greet()) {
      link.close();
      assertNull(line(socket), "the connection is closed");
    }
    robot.setSoTimeout(600); // longer than the first wait for another attempt
    assertThrows(SocketTimeoutException.class, () -> robot.accept().close());
    assertTrue(heard.isEmpty(), heard::toString);
  }

  @Test
  void ofStatesThatComeVeryFastTheNewestIsTold() throws Exception {
    int flood = 200_000;
    try (Socket socket = greet()) {
      StringBuilder lines = new StringBuilder();
      for (int i = 0; i < flood; i++) {
        lines.append(state(i, "")).append('\n');
        if (i % 1_000 == 0 || i == flood - 1) {
          socket.getOutputStream().write(lines.toString().getBytes(StandardCharsets.UTF_8));
          lines.setLength(0);
        }
      }

      heard.await(State.class, state -> state.stamp() == flood - 1);
      assertTrue(heard.passedOver() > flood * 0.9, heard.passedOver() + " were not even read");
    }
  }

  @Test
  void whatIsSaidBetweenStatesAndFaultsThatChangeAreTold() throws Exception {
    String fault = "{\"code\":\"HOT\",\"text\":\"It is hot.\"}";
    try (Socket socket = greet()) {
      say(
          socket,
          String.join(
              "\n",
              state(1, ""),
              state(2, ""),
              state(3, fault),
              state(4, fault),
              "{\"type\":\"ack\",\"seq\":5}",
              state(6, ""),
              state(7, "")));

      heard.await(State.class, s -> s.stamp() == 2);
      heard.await(State.class, s -> s.stamp() == 4);
      assertEquals(new Ack(5), heard.next());
      heard.await(State.class, s -> s.stamp() == 7);
    }
  }

  @Test
  void robotThatSaysMoreThanCanBeTakenIsLeft() throws Exception {
    try (Socket socket = greet()) {
      heard.setFull();
      say(socket, "{\"type\":\"ack\",\"seq\":1}");

      assertEquals(
          "r1 sends more than the server can take, so the connection was closed.",
          heard.await(LinkRecorder.End.class).sentence());
      assertNull(line(socket), "the connection is closed");
    }
  }

  @Test
  void robotThatConnectsAndEndsAgainAndAgainIsConnectedLaterEachTime() throws Exception {
    long begin = System.nanoTime();
    for (int i = 0; i < 5; i++) {
      greet().close();
      heard.await(LinkRecorder.End.class);
    }

    // 0.25 + 0.5 + 1 + 2 s
    assertTrue(System.nanoTime() - begin > 3_700_000_000L, "it is given no pause");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "\"pose\":{\"x\":1e9,\"y\":0.5,\"theta\":0}",
        "\"pose\":{\"x\":NaN,\"y\":0.5,\"theta\":0}",
        "\"pose\":{\"x\":1e999,\"y\":0.5,\"theta\":0}",
        "\"pose\":{\"x\":-Infinity,\"y\":0.5,\"theta\":0}",
        "\"battery\":7",
        "\"ranges\":[-1]",
        "\"obstacles\":[{\"x\":0.5,\"y\":-1e7}]",
        "\"twist\":{\"v\":1e6,\"w\":0}"
      })
  void figuresThatCannotBeTrueAreRefused(String figure) throws Exception {
    String field = figure.substring(0, figure.indexOf(':'));
    try (Socket socket = greet()) {
      say(socket, state(1, "").replaceAll(field + ":(\\{[^}]*\\}|\\[[^]]*\\]|[^,}]*)", figure));
      say(socket, state(2, ""));

      assertEquals(2, heard.await(State.class).stamp());
    }
  }

  @ParameterizedTest
  @CsvSource({
    "maxLoad, 10001, carries 10001 kg",
    "maxSpeed, 1e-9, drives 0 m/s",
    "maxSpeed, 5.1, drives 5.1 m/s",
    "maxTurnRate, 0.001, turns 0.001 rad/s",
    "footprint, 0.049, is 0.049 m wide",
    "sensorRange, 1e6, sees 1000000 m"
  })
  void robotThatSaysOfItselfWhatCannotBeTrueIsRefused(String field, String value, String part)
      throws Exception {
    String figure = "\"" + field + "\":" + value;
    String hello = HELLO.replaceFirst("\"" + field + "\":[0-9.]+", figure);
    try (Socket socket = robot.accept()) {
      say(socket, hello.equals(HELLO) ? HELLO.replaceFirst("\\{", "{" + figure + ",") : hello);

      String sentence = heard.await(LinkRecorder.Refusal.class).sentence();
      assertTrue(sentence.contains(part), sentence);
    }
  }

  @Test
  void robotThatIsWiderThanRobotsMayBeIsRefused() throws Exception {
    try (Socket socket = robot.accept()) {
      say(socket, HELLO.replace("\"footprint\":0.255", "\"footprint\":1.001"));

      assertEquals(
          "r1 says that it is 1.001 m wide; robots here are 1 m wide at most."
              + " Correct its configuration, or the setting widestRobot.",
          heard.await(LinkRecorder.Refusal.class).sentence());
    }
    try (Socket socket = robot.accept()) {
      say(socket, HELLO.replace("\"footprint\":0.255", "\"footprint\":1.0"));

      assertEquals(1, heard.await(Hello.class).footprint());
    }
  }

  private static String state(long stamp, String errors) {
    return """
        {"type":"state","stamp":%d,"localised":true,"pose":{"x":0.5,"y":0.5,"theta":0},\
        "twist":{"v":0,"w":0},"mode":"IDLE","task":null,"phase":0,"role":"ALONE","drive":0,\
        "segment":0,"released":0,"battery":0.8,"ranges":[],"obstacles":[],"errors":[%s]}"""
        .formatted(stamp, errors);
  }

  private Socket greet() throws IOException, InterruptedException {
    Socket socket = robot.accept();
    say(socket, HELLO);
    assertEquals(19, ((Hello) heard.next()).lastSeq());
    return socket;
  }

  private RobotLink open(String host, int port, LinkRecorder listener) throws IOException {
    return new TcpRobotLinkFactory(new LinkTls(IdentityFile.open(keys)), false)
        .open(new RobotAddress("r1", host, port, null), listener);
  }

  private static void say(Socket socket, String line) throws IOException {
    socket.getOutputStream().write((line + "\n").getBytes(StandardCharsets.UTF_8));
  }

  private static String line(Socket socket) throws IOException {
    return new BufferedReader(
            new InputStreamReader(socket.getInputStream(), StandardCharsets.UTF_8))
        .readLine();
  }
}
