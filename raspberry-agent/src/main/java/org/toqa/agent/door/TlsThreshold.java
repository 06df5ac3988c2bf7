package org.toqa.agent.door;

import java.io.IOException;
import java.net.Socket;
import java.time.Duration;
import java.util.function.Consumer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.link.trust.HandshakeException;
import org.toqa.link.trust.LinkSocket;
import org.toqa.link.trust.LinkTls;

/**
 * Lets in who has shown a certificate on the guest list. Each connection has a thread and five
 * seconds of its own, so one that is slow holds up nobody.
 */
final class TlsThreshold implements Threshold {

  private static final Logger log = LoggerFactory.getLogger(TlsThreshold.class);
  private static final Duration LIMIT = Duration.ofSeconds(5);

  private final LinkTls tls;
  private final GuestList guests;
  private final PairingDesk desk;
  private final Refusals refusals;
  private final Consumer<LinkSocket> taken;
  private final WaitingRoom room = new WaitingRoom();

  TlsThreshold(
      LinkTls tls,
      GuestList guests,
      PairingDesk desk,
      Refusals refusals,
      Consumer<LinkSocket> taken) {
    this.tls = tls;
    this.guests = guests;
    this.desk = desk;
    this.refusals = refusals;
    this.taken = taken;
  }

  @Override
  public void receive(Socket client) {
    room.enter(client).ifPresent(TlsThreshold::hangUp);
    Thread.startVirtualThread(() -> identify(client));
  }

  @Override
  public void close() {
    room.all().forEach(TlsThreshold::hangUp);
  }

  private void identify(Socket client) {
    try {
      LinkSocket link = tls.accept(client, guests, LIMIT);
      if (link.isForPairing()) {
        desk.converse(link);
      } else {
        taken.accept(link);
      }
    } catch (HandshakeException e) {
      log.debug("A handshake failed.", e);
      refusals.note(sentence(e.reason()), client.getInetAddress());
    } catch (IOException e) {
      log.debug("A handshake failed.", e);
    } finally {
      room.leave(client);
    }
  }

  private static String sentence(HandshakeException.Reason reason) {
    return switch (reason) {
      case STRANGER -> "%s was refused: it is neither this robot's server nor its leader.";
      case REFUSED -> "%s does not trust this robot's certificate.";
      case NOT_TLS -> "%s was refused: it does not encrypt.";
      case CUT_OFF -> "A connection from %s ended before it had shown who it is.";
      case LATE -> "%s was refused: it took too long to show who it is.";
      case FAILED -> "%s was refused: no connection by TLS 1.3 came about.";
    };
  }

  private static void hangUp(Socket socket) {
    try {
      socket.close();
    } catch (IOException e) {
      log.debug("Closing a connection failed.", e);
    }
  }
}
