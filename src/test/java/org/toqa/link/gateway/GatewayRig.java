package org.toqa.link.gateway;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.InstantSource;
import java.util.List;
import java.util.Map;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import org.toqa.link.gateway.GatewayAgent.Server;
import org.toqa.link.trust.IdentityFile;
import org.toqa.link.trust.LinkTls;
import org.toqa.testbed.FaultyTcpProxy;

/** A server's port for gateways, and a gateway named dock that dials it through a cable. */
public final class GatewayRig implements AutoCloseable {
  private static final long LIMIT_NANOS = 20_000_000_000L;

  private final LinkTls server;
  private final LinkTls gateway;
  private final GatewayPort port;
  private final FaultyTcpProxy cable;
  private final GatewayAgent agent;

  /**
   * Waits until the gateway is connected.
   *
   * @param allowed where the gateway may connect to
   */
  public GatewayRig(Path folder, List<String> allowed) throws IOException {
    server = identity(folder, "server");
    gateway = identity(folder, "gateway");
    port = listen(0);
    cable = new FaultyTcpProxy(port.port());
    agent = dial(cable.port(), gateway, allowed);
    await(() -> port.states().getFirst().isConnected());
  }

  static LinkTls identity(Path folder, String name) throws IOException {
    return new LinkTls(IdentityFile.open(Files.createDirectories(folder.resolve(name))));
  }

  private GatewayPort listen(int number) throws IOException {
    return new GatewayPort(
        new InetSocketAddress(InetAddress.getLoopbackAddress(), number),
        server,
        Map.of("dock", gateway.fingerprint()),
        InstantSource.system());
  }

  GatewayAgent dial(int at, LinkTls as, List<String> allowed) {
    return new GatewayAgent(
        new Server("127.0.0.1", at, server.fingerprint()), AllowedAddresses.of(allowed), as);
  }

  public GatewayPort port() {
    return port;
  }

  LinkTls gateway() {
    return gateway;
  }

  LinkTls server() {
    return server;
  }

  /** Between gateway and server. */
  public FaultyTcpProxy cable() {
    return cable;
  }

  static void await(BooleanSupplier condition) {
    long end = System.nanoTime() + LIMIT_NANOS;
    while (!condition.getAsBoolean()) {
      if (System.nanoTime() > end) {
        throw new AssertionError("it is still not so");
      }
      LockSupport.parkNanos(1_000_000);
    }
  }

  @Override
  public void close() throws IOException {
    agent.close();
    cable.close();
    port.close();
  }
}
