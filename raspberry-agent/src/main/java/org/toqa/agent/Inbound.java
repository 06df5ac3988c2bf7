package org.toqa.agent;

import org.toqa.link.message.MessageReading;
import org.toqa.link.message.ServerMessage;

/** What the threads of the connections hand to the tick, in the order in which it happened. */
sealed interface Inbound {
  ServerConnection connection();

  record Opened(ServerConnection connection) implements Inbound {}

  record Heard(ServerConnection connection, MessageReading<ServerMessage> line)
      implements Inbound {}
}
