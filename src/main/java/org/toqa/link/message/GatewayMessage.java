package org.toqa.link.message;

import com.fasterxml.jackson.annotation.JsonSubTypes;
import com.fasterxml.jackson.annotation.JsonSubTypes.Type;
import com.fasterxml.jackson.annotation.JsonTypeInfo;

/**
 * What a gateway and a server say to each other. The gateway makes all connections; the first line
 * of each says what it is for: {@link Gateway} for what the two say to each other, {@link Stream}
 * for the bytes of one link to a robot.
 */
@JsonTypeInfo(use = JsonTypeInfo.Id.NAME, property = "type")
@JsonSubTypes({
  @Type(value = GatewayMessage.Gateway.class, name = "gateway"),
  @Type(value = GatewayMessage.Stream.class, name = "stream"),
  @Type(value = GatewayMessage.Open.class, name = "open"),
  @Type(value = GatewayMessage.NotOpened.class, name = "not-opened"),
  @Type(value = GatewayMessage.Ping.class, name = "ping"),
})
public sealed interface GatewayMessage {

  /** Of this protocol. */
  int VERSION = 1;

  /** The gateway is there. */
  record Gateway(int version) implements GatewayMessage {}

  /**
   * What follows on this connection is said by the robot.
   *
   * @param stream the number by which the server has asked for it
   */
  record Stream(long stream) implements GatewayMessage {}

  /**
   * The server wants to talk to a robot.
   *
   * @param stream its number: not yet used on this connection
   * @param host as the gateway's network knows it
   * @param port of TCP
   */
  record Open(long stream, String host, int port) implements GatewayMessage {}

  /**
   * The gateway cannot do it.
   *
   * @param text what the network said
   */
  record NotOpened(long stream, Reason reason, String text) implements GatewayMessage {}

  /** One end is there: the server says it each second, the gateway answers. */
  record Ping() implements GatewayMessage {}

  /** Why there is no connection to a robot. */
  enum Reason {
    /** The gateway's configuration does not allow the address. */
    NOT_ALLOWED,
    /** Nobody knows a host of that name. */
    HOST_NOT_KNOWN,
    /** Nothing came back in time. */
    DOES_NOT_ANSWER,
    /** The network says so. */
    CANNOT_BE_REACHED,
    /** The gateway carries as many links as it can. */
    TOO_MANY_LINKS
  }
}
