package org.toqa.telemetry.mqtt;

import io.netty.channel.ChannelDuplexHandler;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelPromise;
import io.netty.handler.codec.mqtt.MqttConnectMessage;
import io.netty.handler.codec.mqtt.MqttConnectVariableHeader;
import io.netty.handler.codec.mqtt.MqttFixedHeader;
import io.netty.handler.codec.mqtt.MqttMessage;
import io.netty.handler.codec.mqtt.MqttMessageType;
import io.netty.handler.codec.mqtt.MqttProperties;
import io.netty.handler.codec.mqtt.MqttProperties.MqttPropertyType;
import io.netty.handler.codec.mqtt.MqttPublishMessage;
import io.netty.handler.codec.mqtt.MqttQoS;
import io.netty.util.ReferenceCountUtil;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;

/**
 * Stands before the embedded broker on each of its connections, and does what the broker has no
 * rules for:
 *
 * <ul>
 *   <li>a last will is for its user's own topic;
 *   <li>nothing but what may be is kept for later, and no session outlives its connection;
 *   <li>who sends too much is read more slowly, and TCP tells him;
 *   <li>who does not acknowledge what he is sent is sent away.
 * </ul>
 *
 * Whether a user is who he says he is, the broker asks after it. Confined to its connection's
 * thread.
 */
final class BrokerGuard extends ChannelDuplexHandler {
  static final int MESSAGES_A_SECOND = 200;

  /** As often those that wait are let on. */
  private static final Duration TURN = Duration.ofMillis(50);

  private static final int MESSAGES_A_TURN = MESSAGES_A_SECOND / 20;

  private static final Duration ACKNOWLEDGE_LIMIT = Duration.ofSeconds(30);

  /** What came too fast, in its order: no more than was read at once. */
  private final Deque<Object> waiting = new ArrayDeque<>();

  private @Nullable MqttUser user;

  /** Messages that may still be let on in this turn. */
  private int left = MESSAGES_A_SECOND;

  private boolean hasTurns;

  /** Messages with a QoS that were sent and not acknowledged. */
  private int unacknowledged;

  private boolean wasAcknowledged;

  @Override
  public void channelRead(ChannelHandlerContext context, Object message) {
    if (!waiting.isEmpty()) {
      waiting.add(message);
      return;
    }
    if (message instanceof MqttPublishMessage && !(user instanceof MqttUser.Server)) {
      startTurns(context);
      if (left == 0) {
        waiting.add(message);
        context.channel().config().setAutoRead(false);
        return;
      }
      left--;
    }
    letOn(context, message);
  }

  private void startTurns(ChannelHandlerContext context) {
    if (!hasTurns) {
      hasTurns = true;
      scheduleTurn(context);
    }
  }

  private void scheduleTurn(ChannelHandlerContext context) {
    var _ =
        context.executor().schedule(() -> turn(context), TURN.toMillis(), TimeUnit.MILLISECONDS);
  }

  private void turn(ChannelHandlerContext context) {
    boolean wasFull = !waiting.isEmpty();
    left = Math.min(MESSAGES_A_SECOND, left + MESSAGES_A_TURN);
    while (!waiting.isEmpty() && left > 0) {
      left--;
      letOn(context, waiting.remove());
    }
    if (wasFull && waiting.isEmpty()) {
      context.channel().config().setAutoRead(true);
    }
    hasTurns = context.channel().isActive() && left < MESSAGES_A_SECOND;
    if (hasTurns) {
      scheduleTurn(context);
    }
  }

  private void letOn(ChannelHandlerContext context, Object message) {
    switch (message) {
      case MqttConnectMessage connect -> receiveConnect(context, connect);
      case MqttPublishMessage publish -> receivePublish(context, publish);
      case MqttMessage other -> {
        if (isAcknowledgement(other)) {
          unacknowledged = Math.max(0, unacknowledged - 1);
          wasAcknowledged = true;
        }
        context.fireChannelRead(other);
      }
      default -> context.fireChannelRead(message);
    }
  }

  /** Of QoS 1, or the last of QoS 2. */
  private static boolean isAcknowledgement(MqttMessage message) {
    MqttFixedHeader header = message.fixedHeader(); // null where the message cannot be read
    return header != null
        && (header.messageType() == MqttMessageType.PUBACK
            || header.messageType() == MqttMessageType.PUBCOMP);
  }

  private void receiveConnect(ChannelHandlerContext context, MqttConnectMessage connect) {
    String name = connect.payload().userName();
    Optional<MqttUser> named = name == null ? Optional.empty() : MqttUser.of(name);
    boolean mayWill =
        !connect.variableHeader().isWillFlag()
            || named.filter(known -> known.mayWill(connect.payload().willTopic())).isPresent();
    if (named.isEmpty() || user != null || !mayWill) {
      ReferenceCountUtil.release(connect);
      var _ = context.close();
      return;
    }
    user = named.get();
    context.fireChannelRead(clean(connect));
  }

  /** The same for a session that ends with its connection. */
  private static MqttConnectMessage clean(MqttConnectMessage connect) {
    MqttConnectVariableHeader given = connect.variableHeader();
    MqttProperties properties = new MqttProperties();
    given
        .properties()
        .listAll()
        .forEach(
            property -> {
              if (property.propertyId() != MqttPropertyType.SESSION_EXPIRY_INTERVAL.value()) {
                properties.add(property);
              }
            });
    return new MqttConnectMessage(
        connect.fixedHeader(),
        new MqttConnectVariableHeader(
            given.name(),
            given.version(),
            given.hasUserName(),
            given.hasPassword(),
            given.isWillRetain(),
            given.willQos(),
            given.isWillFlag(),
            true,
            given.keepAliveTimeSeconds(),
            properties),
        connect.payload());
  }

  private void receivePublish(ChannelHandlerContext context, MqttPublishMessage publish) {
    MqttUser publisher = user;
    if (publisher == null) {
      ReferenceCountUtil.release(publish);
      var _ = context.close();
      return;
    }
    boolean mayBeKept = publisher.mayRetain(publish.variableHeader().topicName());
    context.fireChannelRead(
        publish.fixedHeader().isRetain() && !mayBeKept ? notRetained(publish) : publish);
  }

  private static MqttPublishMessage notRetained(MqttPublishMessage publish) {
    MqttFixedHeader given = publish.fixedHeader();
    MqttFixedHeader header =
        new MqttFixedHeader(
            given.messageType(), given.isDup(), given.qosLevel(), false, given.remainingLength());
    return new MqttPublishMessage(header, publish.variableHeader(), publish.payload());
  }

  @Override
  public void write(ChannelHandlerContext context, Object message, ChannelPromise promise) {
    if (message instanceof MqttPublishMessage publish
        && publish.fixedHeader().qosLevel() != MqttQoS.AT_MOST_ONCE
        && !publish.fixedHeader().isDup()) {
      if (unacknowledged == 0) {
        scheduleCheck(context);
      }
      unacknowledged++;
    }
    var _ = context.write(message, promise);
  }

  private void scheduleCheck(ChannelHandlerContext context) {
    wasAcknowledged = false;
    var _ =
        context
            .executor()
            .schedule(
                () -> checkAcknowledged(context),
                ACKNOWLEDGE_LIMIT.toMillis(),
                TimeUnit.MILLISECONDS);
  }

  private void checkAcknowledged(ChannelHandlerContext context) {
    if (unacknowledged > 0 && !wasAcknowledged) {
      var _ = context.close();
    } else if (unacknowledged > 0) {
      scheduleCheck(context);
    }
  }

  @Override
  public void channelInactive(ChannelHandlerContext context) {
    waiting.forEach(ReferenceCountUtil::release);
    waiting.clear();
    context.fireChannelInactive();
  }
}
