package org.toqa.agent.access;

import java.net.Socket;

/** What a connection that was taken must pass to become one of the link. */
interface ConnectionAcceptor extends AutoCloseable {

  /** Hands the connection on, or closes it; does not wait for the other end. */
  void accept(Socket client);

  @Override
  void close();
}
