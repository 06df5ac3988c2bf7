package org.toqa.telemetry.mqtt;

import io.netty.bootstrap.ChannelInitializerExtension;
import io.netty.channel.Channel;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInboundHandlerAdapter;

/**
 * Puts a {@link BrokerGuard} on each connection of the embedded broker, which offers no place for
 * one itself. Netty finds it as a service, where {@link #enable} was called before.
 */
public final class BrokerGuardExtension extends ChannelInitializerExtension {
  /** The broker's own handler of messages, in its pipelines. */
  private static final String BROKER_HANDLER = "handler";

  /** To be called before a server of Netty is started. */
  static void enable() {
    System.setProperty(EXTENSIONS_SYSTEM_PROPERTY, "serviceload");
  }

  @Override
  public void postInitializeServerChildChannel(Channel channel) {
    channel.pipeline().addLast(new Installer());
  }

  /** Waits until the broker has made the pipeline; a connection without a guard is closed. */
  private static final class Installer extends ChannelInboundHandlerAdapter {
    @Override
    public void channelRegistered(ChannelHandlerContext context) {
      context.pipeline().addBefore(BROKER_HANDLER, "guard", new BrokerGuard());
      context.fireChannelRegistered();
      context.pipeline().remove(this);
    }

    @Override
    public void exceptionCaught(ChannelHandlerContext context, Throwable cause) {
      var _ = context.close();
    }
  }
}
