package org.toqa.link.http;

import java.net.URI;
import java.net.URISyntaxException;
import org.jspecify.annotations.Nullable;
import org.toqa.link.trust.Fingerprint;

/**
 * Where a robot takes commands over HTTP, and how the two ends know each other.
 *
 * @param port of TCP, 1 to 65535
 * @param token that the robot wants
 * @param fingerprint of the certificate that it must show; null: it does not encrypt
 */
public record HttpRobotAddress(
    String host, int port, RobotToken token, @Nullable Fingerprint fingerprint) {

  /**
   * @param path with a slash at its front
   * @throws HttpRobotException the host is no name and no address
   */
  URI uri(String path) throws HttpRobotException {
    try {
      return new URI(fingerprint == null ? "http" : "https", null, host, port, path, null, null);
    } catch (URISyntaxException e) {
      throw new HttpRobotException(
          HttpRobotException.Reason.HOST_NOT_KNOWN, "there is no host " + host, e);
    }
  }
}
