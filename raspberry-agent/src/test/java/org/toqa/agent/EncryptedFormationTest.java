package org.toqa.agent;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Objects;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.link.message.AgentMessage.Done;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.ServerMessage.Follow;
import org.toqa.link.message.ServerMessage.Follower;
import org.toqa.link.message.ServerMessage.Lead;
import org.toqa.link.trust.Fingerprint;
import org.toqa.link.trust.HandshakeException.Reason;
import org.toqa.link.trust.IdentityFile;
import org.toqa.link.trust.LinkSocket;
import org.toqa.link.trust.LinkTls;
import org.toqa.motion.Segment;

/** Three paired daemons that carry one load: their links to each other are pinned too. */
@Tag("full")
@Timeout(120)
class EncryptedFormationTest {

  private static final Segment STRAIGHT = new Segment(0.25, 0, 4);

  /** Longer than an outsider is kept waiting, in a world of three times real time. */
  private static final Segment LONG = new Segment(0.25, 0, 60);

  @TempDir Path folder;
  private FormationRig group;

  @BeforeEach
  void open() throws IOException {
    group = new FormationRig(folder, tls("server"));
  }

  @AfterEach
  void close() {
    group.close();
  }

  private LinkTls tls(String name) throws IOException {
    return new LinkTls(IdentityFile.open(Files.createDirectories(folder.resolve(name))));
  }

  @Test
  void groupDrivesOverPinnedLinksAndEachFlags() {
    group.startFormation(List.of(STRAIGHT));

    assertEquals(new Done(FormationRig.TASK, 2, 2), group.server(0).awaitDone());
    assertEquals(new Done(FormationRig.TASK, 2, 1), group.server(1).awaitDone());
    assertEquals(new Done(FormationRig.TASK, 2, 1), group.server(2).awaitDone());
  }

  @Test
  void outsiderCannotLeadAFollower() throws IOException {
    group.startFormation(List.of(LONG));
    group.server(1).awaitState(s -> s.mode() == Mode.FOLLOWING);
    int port = group.port(1);
    Fingerprint follower = new Fingerprint(Objects.requireNonNull(group.fingerprint(1)));
    try (LinkSocket made =
        tls("outsider")
            .connect(
                new Socket(InetAddress.getLoopbackAddress(), port),
                LinkTls.LINK,
                (peer, _) -> peer.equals(follower),
                Duration.ofSeconds(5))) {
      IOException e = assertThrows(IOException.class, () -> made.in().read());
      assertEquals(Reason.REJECTED_BY_PEER, LinkTls.reasonOf(e));
    }
    group
        .server(1)
        .awaitState(
            s ->
                s.mode() == Mode.FOLLOWING
                    && s.errors().stream().anyMatch(fault -> fault.code().equals("REFUSED")));
  }

  @Test
  void pairedRobotFollowsNobodyWithoutAFingerprint() {
    String reason =
        group
            .server(1)
            .rejectReason(
                new Follow(
                    1,
                    FormationRig.TASK,
                    "r1",
                    null,
                    FormationRig.SHAPE.offsets().get(0),
                    FormationRig.TOLERANCE,
                    null));

    assertEquals("r2 is paired: it knows its leader by the fingerprint, which is missing.", reason);
  }

  @Test
  void fingerprintThatIsNoneIsRefused() {
    Follower follower = new Follower("r2", "127.0.0.1", 7275, "ab:cd");
    String reason =
        group
            .server(0)
            .rejectReason(
                new Lead(1, FormationRig.TASK, FormationRig.TOLERANCE, List.of(follower), null));

    assertTrue(reason.startsWith("The fingerprint of r2 is null or has 64"), reason);
  }
}
