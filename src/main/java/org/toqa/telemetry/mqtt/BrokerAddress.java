package org.toqa.telemetry.mqtt;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.security.cert.Certificate;
import java.security.cert.CertificateFactory;
import java.util.Collection;
import javax.net.SocketFactory;
import javax.net.ssl.SSLContext;
import javax.net.ssl.SSLSocketFactory;
import javax.net.ssl.TrustManagerFactory;
import org.jspecify.annotations.Nullable;

/**
 * Where the server's own connections find their broker.
 *
 * @param uri as Paho has it: {@code tcp://} or {@code ssl://}
 * @param isOwn whether it is known by its certificate, not by its name
 */
public record BrokerAddress(String uri, String shown, SocketFactory sockets, boolean isOwn) {

  static BrokerAddress plain(String host, int port) {
    return new BrokerAddress(
        "tcp://" + bracketed(host) + ":" + port,
        "mqtt://" + bracketed(host) + ":" + port,
        new NoDelaySocketFactory(SocketFactory.getDefault()),
        false);
  }

  /**
   * @param trusted PEM file; null: the certificates that Java trusts
   * @throws IOException it cannot be used; the message says why
   */
  static BrokerAddress tls(String host, int port, @Nullable Path trusted, boolean isOwn)
      throws IOException {
    return new BrokerAddress(
        "ssl://" + bracketed(host) + ":" + port,
        "mqtts://" + bracketed(host) + ":" + port,
        new NoDelaySslSocketFactory(trusting(trusted)),
        isOwn);
  }

  /**
   * Of an external broker.
   *
   * @throws IOException its certificates cannot be used; the message says what to do
   */
  public static BrokerAddress of(BrokerSettings.External broker) throws IOException {
    boolean isTls = "mqtts".equals(broker.address().getScheme());
    int given = broker.address().getPort();
    int port = given > 0 ? given : isTls ? 8883 : 1883;
    String host = broker.address().getHost();
    return isTls ? tls(host, port, broker.ca(), false) : plain(host, port);
  }

  private static String bracketed(String host) {
    return host.contains(":") && !host.startsWith("[") ? "[" + host + "]" : host;
  }

  private static SSLSocketFactory trusting(@Nullable Path file) throws IOException {
    try {
      TrustManagerFactory trust =
          TrustManagerFactory.getInstance(TrustManagerFactory.getDefaultAlgorithm());
      trust.init(file == null ? null : keyStore(file));
      SSLContext context = SSLContext.getInstance("TLS");
      context.init(null, trust.getTrustManagers(), null);
      return context.getSocketFactory();
    } catch (GeneralSecurityException | IOException e) {
      throw new IOException(
          "The certificates in \"%s\" cannot be used (%s): give them as PEM."
              .formatted(file, e.getMessage()),
          e);
    }
  }

  private static KeyStore keyStore(Path file) throws GeneralSecurityException, IOException {
    KeyStore store = KeyStore.getInstance(KeyStore.getDefaultType());
    store.load(null, null);
    try (InputStream pem = Files.newInputStream(file)) {
      Collection<? extends Certificate> certificates =
          CertificateFactory.getInstance("X.509").generateCertificates(pem);
      if (certificates.isEmpty()) {
        throw new GeneralSecurityException("no certificate is in it");
      }
      for (Certificate certificate : certificates) {
        store.setCertificateEntry("trusted-" + store.size(), certificate);
      }
    }
    return store;
  }
}
