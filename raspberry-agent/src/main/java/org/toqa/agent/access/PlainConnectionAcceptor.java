package org.toqa.agent.access;

import java.net.Socket;
import java.util.function.Consumer;
import org.toqa.link.trust.LinkSocket;

/** Accepts every peer: the link is on loopback, or the configuration wants it so. */
record PlainConnectionAcceptor(Consumer<LinkSocket> onAccepted) implements ConnectionAcceptor {

  @Override
  public void accept(Socket client) {
    onAccepted.accept(LinkSocket.plain(client));
  }

  @Override
  public void close() {}
}
