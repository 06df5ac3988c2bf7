package org.toqa.link;

import java.io.IOException;
import java.time.Duration;
import java.util.Objects;
import org.toqa.link.message.DecodeResult.Decoded;
import org.toqa.link.message.LineReader;
import org.toqa.link.message.LinkCodec;
import org.toqa.link.message.PairingMessage;
import org.toqa.link.message.PairingMessage.Pair;
import org.toqa.link.message.PairingMessage.Paired;
import org.toqa.link.message.PairingMessage.Unpaired;
import org.toqa.link.trust.Fingerprint;
import org.toqa.link.trust.HandshakeException;
import org.toqa.link.trust.HandshakeException.Reason;
import org.toqa.link.trust.LinkSocket;
import org.toqa.link.trust.LinkTls;
import org.toqa.link.trust.PairingCode;
import org.toqa.link.trust.PairingProof;
import org.toqa.link.trust.TimeLimit;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * The server's side of pairing with one robot:
 *
 * <ol>
 *   <li>The certificate that it shows must be the code's; else nothing is said.
 *   <li>The server says {@code pair}, with the proof that it knows the code's secret.
 *   <li>The robot says {@code paired}, with a proof of the same.
 * </ol>
 */
record PairingClient(RobotConnector connector, RobotAddress address, PairingCode code) {

  /** For all of it: a little less than whoever asked waits for the answer. */
  private static final Duration LIMIT = Duration.ofSeconds(9);

  PairingResult pair() {
    long end = System.nanoTime() + LIMIT.toNanos();
    try {
      LinkSocket carrier = connector.reachToPair(address);
      try (LinkSocket link =
              connector
                  .tls()
                  .connect(
                      carrier, LinkTls.PAIRING, (peer, _) -> code.isOf(peer), remainingTime(end));
          TimeLimit _ = link.startTimeLimit(remainingTime(end))) {
        return exchangeProofs(link);
      }
    } catch (LinkException e) {
      return new PairingResult.Unreachable(e.sentence());
    } catch (HandshakeException e) {
      return e.reason() == Reason.UNTRUSTED_PEER
          ? new PairingResult.Refused(Phrase.CODE_OF_ANOTHER.with(address.place()))
          : unreachable();
    } catch (IOException e) {
      return unreachable();
    }
  }

  private static Duration remainingTime(long end) {
    return Duration.ofNanos(Math.max(0, end - System.nanoTime()));
  }

  private PairingResult unreachable() {
    return new PairingResult.Unreachable(
        Phrase.DOES_NOT_PAIR.with(address.place(), address.robot()));
  }

  private PairingResult exchangeProofs(LinkSocket link) throws IOException {
    Fingerprint peer = Objects.requireNonNull(link.peer());
    Fingerprint own = connector.tls().fingerprint();
    link.out()
        .write(
            LinkCodec.encode(new Pair(address.robot(), PairingProof.SERVER.of(code, peer, own))));
    LineReader.Line line = new LineReader(link.in()).readLine();
    if (line == null
        || !(LinkCodec.decodePairingMessage(line) instanceof Decoded<PairingMessage>(var answer))) {
      return unreachable();
    }
    return switch (answer) {
      case Paired(String name, String _) when !name.equals(address.robot()) ->
          new PairingResult.Unreachable(
              Phrase.HAS_ANOTHER_NAME.with(address.place(), address.robot()));
      case Paired(String _, String proof) when PairingProof.ROBOT.isValid(proof, code, peer, own) ->
          new PairingResult.Paired(peer);
      case Paired _ -> new PairingResult.Refused(Phrase.DOES_NOT_KNOW_CODE.with(address.place()));
      case Unpaired(String reason) -> new PairingResult.Refused(Sentence.verbatim(reason));
      case Pair _ -> unreachable();
    };
  }
}
