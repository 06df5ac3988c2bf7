package org.toqa.agent.door;

import java.net.Socket;

/** What a connection that was taken must pass to become one of the link. */
interface Threshold extends AutoCloseable {

  /** Hands the connection on, or closes it; does not wait for the other end. */
  void receive(Socket client);

  @Override
  void close();
}
