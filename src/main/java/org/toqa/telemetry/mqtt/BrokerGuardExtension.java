package org.toqa.telemetry.mqtt;

import io.netty.bootstrap.ChannelInitializerExtension;
import io.netty.channel.Channel;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInboundHandlerAdapter;
import io.netty.channel.ServerChannel;
import io.netty.util.AttributeKey;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;

/**
 * Puts a {@link BrokerGuard} on each connection of the embedded broker, which offers no place for
 * one itself, where there is a place for that. Netty finds it as a service, once {@link #start} was
 * called.
 */
public final class BrokerGuardExtension extends ChannelInitializerExtension {
  /** The broker's own handler of messages, in its pipelines. */
  private static final String BROKER_HANDLER = "handler";

  /** Of the server of Netty that is being started. */
  private static final ScopedValue<BrokerDoor> STARTED = ScopedValue.newInstance();

  private static final AttributeKey<BrokerDoor> DOOR = AttributeKey.valueOf("toqa.door");

  /** What starts a broker, and takes its port on this thread. */
  interface Start {
    void run() throws IOException;
  }

  /** Starts a broker whose connections come by that door. */
  static void start(BrokerDoor door, Start start) throws IOException {
    System.setProperty(EXTENSIONS_SYSTEM_PROPERTY, "serviceload");
    ScopedValue.where(STARTED, door)
        .call(
            () -> {
              start.run();
              return door;
            });
  }

  @Override
  public void postInitializeServerListenerChannel(ServerChannel channel) {
    channel.attr(DOOR).set(STARTED.get());
  }

  @Override
  public void postInitializeServerChildChannel(Channel channel) {
    channel.pipeline().addLast(new Installer(channel.parent().attr(DOOR).get()));
  }

  /** Waits until the broker has made the pipeline; a connection without a guard is closed. */
  private static final class Installer extends ChannelInboundHandlerAdapter {
    private final BrokerDoor door;
    private boolean isRefused;

    Installer(BrokerDoor door) {
      this.door = door;
    }

    @Override
    public void channelRegistered(ChannelHandlerContext context) {
      InetAddress address = ((InetSocketAddress) context.channel().remoteAddress()).getAddress();
      isRefused = !door.tryEnter(address);
      if (isRefused) {
        return;
      }
      context.channel().closeFuture().addListener(_ -> door.leave(address));
      context.pipeline().addBefore(BROKER_HANDLER, "guard", new BrokerGuard());
      context.fireChannelRegistered();
      context.pipeline().remove(this);
    }

    /** The broker's handlers can close it by now. */
    @Override
    public void channelActive(ChannelHandlerContext context) {
      if (isRefused) {
        var _ = context.close();
      } else {
        context.fireChannelActive();
      }
    }

    /** The broker has not heard of who was refused. */
    @Override
    public void channelInactive(ChannelHandlerContext context) {
      if (!isRefused) {
        context.fireChannelInactive();
      }
    }

    @Override
    public void exceptionCaught(ChannelHandlerContext context, Throwable cause) {
      var _ = context.close();
    }
  }
}
