package org.toqa.agent.connection;

import org.toqa.link.message.DecodeResult;
import org.toqa.link.message.ServerMessage;

/** What the threads of the connections hand to the tick, in the order in which it happened. */
public sealed interface ConnectionEvent {
  PeerConnection connection();

  record Opened(PeerConnection connection) implements ConnectionEvent {}

  record LineReceived(PeerConnection connection, DecodeResult<ServerMessage> line)
      implements ConnectionEvent {}
}
