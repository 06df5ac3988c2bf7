package org.toqa.agent;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.link.PairingResult.Paired;
import org.toqa.link.RobotAddress;
import org.toqa.link.RobotLink;
import org.toqa.link.TcpRobotLinkFactory;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.State;
import org.toqa.link.message.ServerMessage.Drive;
import org.toqa.link.message.ServerMessage.Ping;
import org.toqa.link.trust.Fingerprint;
import org.toqa.link.trust.IdentityFile;
import org.toqa.link.trust.LinkTls;
import org.toqa.link.trust.PairingCode;
import org.toqa.motion.Segment;
import org.toqa.testbed.LinkRecorder;

/**
 * A daemon in real time that is paired, and what becomes of it. How it ends in a process of its
 * own, without a warning, is in {@link KilledDaemonTest}.
 */
@Tag("full")
@Timeout(120)
class PairedDaemonTest {

  @TempDir Path folder;
  private Path config;
  private DaemonThread daemon;
  private Fingerprint robot;

  /** What a link told. */
  @BeforeEach
  void pair() throws Exception {
    config = folder.resolve("agent.yaml");
    Files.writeString(
        config,
        """
        name: r1
        port: 0
        dataDir: robot
        chassis:
          type: simulated
          start: {x: 2, y: 3, heading: 0}
        """);
    daemon = DaemonThread.start(config, true);
    PairingCode code = PairingCode.parse(daemon.pairingCode()).orElseThrow();
    robot =
        assertInstanceOf(
                Paired.class,
                links("server")
                    .pair(new RobotAddress("r1", "127.0.0.1", daemon.port(), null), code))
            .robot();
  }

  @AfterEach
  void close() throws Exception {
    daemon.close();
  }

  @Test
  void runningDaemonTakesANewCodeAndRunsOn() throws Exception {
    EndedCommand asked = EndedCommand.of("--config", config.toString(), "--pair");

    assertEquals(0, asked.exitCode(), asked.errors());
    PairingCode code =
        PairingCode.parse(asked.errors().replaceAll("(?s)Pairing code: (\\S+) .*", "$1"))
            .orElseThrow();
    assertInstanceOf(
        Paired.class,
        links("other").pair(new RobotAddress("r1", "127.0.0.1", daemon.port(), null), code));
    assertTrue(Files.notExists(folder.resolve("robot/pairing.code")));
  }

  /** The links of a server that has just been started over that folder. */
  private TcpRobotLinkFactory links(String server) throws IOException {
    return new TcpRobotLinkFactory(
        new LinkTls(IdentityFile.open(Files.createDirectories(folder.resolve(server)))), false);
  }

  private RobotLink link(String server, LinkRecorder heard) throws IOException {
    return links(server).open(new RobotAddress("r1", "127.0.0.1", daemon.port(), robot), heard);
  }

  private void restart() throws Exception {
    daemon.close();
    daemon = DaemonThread.start(config, false);
  }

  @Test
  void serverDrivesTheRobotAndBothMayBeStartedAnew() throws Exception {
    LinkRecorder heard = new LinkRecorder();
    try (RobotLink link = link("server", heard)) {
      Hello hello = heard.await(Hello.class);
      link.send(new Drive(1, null, 0, hello.pose(), List.of(new Segment(0.25, 0, 2)), 1, true, 0));
      heard.await(State.class, s -> s.mode() == Mode.DRIVING);
    }
    restart();

    LinkRecorder again = new LinkRecorder();
    try (RobotLink _ = link("server", again)) {
      assertEquals(1, again.await(Hello.class).lastSeq());
    }
  }

  @Test
  void onlyTheirOwnerMayReadTheRobotsFiles() throws IOException {
    for (String file : List.of("link.p12", "server.pin")) {
      assertEquals(
          "rw-------",
          PosixFilePermissions.toString(
              Files.getPosixFilePermissions(folder.resolve("robot").resolve(file))),
          file);
    }
  }

  @Test
  void secondServerIsRefusedAndTheFirstOneIsTold() throws Exception {
    LinkRecorder own = new LinkRecorder();
    LinkRecorder others = new LinkRecorder();
    try (RobotLink first = link("server", own);
        RobotLink _ = link("second", others)) {
      own.await(Hello.class);
      first.send(new Ping(1));

      assertEquals(
          new LinkRecorder.Refusal(
              "r1 does not accept this server: it was paired with another server, or this server’s"
                  + " key is new. Pair it again."),
          others.next(),
          "it was greeted");
      State told =
          own.await(
              State.class, s -> s.errors().stream().anyMatch(e -> e.code().equals("REFUSED")));
      assertEquals(Mode.IDLE, told.mode());
      assertEquals(
          "127.0.0.1 was refused: it is neither this robot's server nor its leader.",
          told.errors().getFirst().text());
    }
  }

  @Test
  void plainTextIsRefusedAndTheServerIsTold() throws Exception {
    LinkRecorder own = new LinkRecorder();
    try (RobotLink first = link("server", own);
        Socket plain = new Socket(InetAddress.getLoopbackAddress(), daemon.port())) {
      own.await(Hello.class);
      first.send(new Ping(1));
      plain
          .getOutputStream()
          .write("{\"type\":\"hold\",\"seq\":1}\n".getBytes(StandardCharsets.UTF_8));
      assertEquals(-1, plain.getInputStream().read());

      State told = own.await(State.class, s -> !s.errors().isEmpty());
      assertEquals("127.0.0.1 was refused: it does not encrypt.", told.errors().getFirst().text());
      assertEquals(Mode.IDLE, told.mode());
    }
  }

  @Test
  void robotWithAnotherKeyIsRefusedByTheServer() throws Exception {
    daemon.close();
    Files.delete(folder.resolve("robot").resolve("link.p12"));
    daemon = DaemonThread.start(config, false);
    LinkRecorder heard = new LinkRecorder();
    try (RobotLink _ = link("server", heard)) {
      assertEquals(
          "The device at 127.0.0.1:%d is not r1: its key differs from the recorded one."
                  .formatted(daemon.port())
              + " If r1 was set up again, pair it again; otherwise find out which device answers there.",
          heard.await(LinkRecorder.Refusal.class).sentence());
    }
  }

  @Test
  void serverWithAnotherKeyIsRefusedByTheRobot() throws Exception {
    Files.delete(folder.resolve("server").resolve("link.p12"));
    LinkRecorder heard = new LinkRecorder();
    try (RobotLink _ = link("server", heard)) {
      assertTrue(
          heard
              .await(LinkRecorder.Refusal.class)
              .sentence()
              .startsWith("r1 does not accept this server"));
    }
  }
}
