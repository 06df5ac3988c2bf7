package org.toqa.telemetry.mqtt;

import java.net.InetAddress;
import java.net.URI;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;

/** Which MQTT broker a server uses. */
public sealed interface BrokerSettings {

  /**
   * One of its own, in its process.
   *
   * @param port TCP port; 0: any free one
   * @param tls null: its connections are not encrypted
   */
  record Embedded(InetAddress address, int port, @Nullable PemFiles tls)
      implements BrokerSettings {}

  /**
   * Another one.
   *
   * @param address {@code mqtt://HOST:PORT} or {@code mqtts://HOST:PORT}
   * @param ca PEM file with the certificates that vouch for it; null: those that Java trusts
   */
  record External(URI address, @Nullable String user, @Nullable String password, @Nullable Path ca)
      implements BrokerSettings {
    @Override
    public String toString() {
      return "External[" + address + "]";
    }
  }

  /** A certificate with those that vouch for it, and its private key as PKCS #8. */
  record PemFiles(Path certificate, Path key) {}
}
