package org.toqa.agent.access;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.link.trust.Fingerprint;
import org.toqa.link.trust.PrivateFile;

/** The file {@code server.pin} in the data folder: the certificate of the robot's only server. */
final class ServerPin {

  private final PrivateFile file;
  private volatile @Nullable Fingerprint server;

  /**
   * @throws IOException with a sentence for people where the file cannot be read
   */
  ServerPin(Path folder) throws IOException {
    file = new PrivateFile(folder.resolve("server.pin"));
    Optional<byte[]> content = file.read();
    if (content.isPresent()) {
      server = parsePin(new String(content.get(), StandardCharsets.US_ASCII).strip());
    }
  }

  private Fingerprint parsePin(String text) throws IOException {
    return Fingerprint.parse(text)
        .orElseThrow(
            () ->
                new IOException(
                    "What is in %s is no fingerprint; remove the file and pair anew."
                        .formatted(file)));
  }

  /** Empty while the robot was never paired. */
  Optional<Fingerprint> server() {
    return Optional.ofNullable(server);
  }

  /** Outlives a loss of power when this returns. */
  void save(Fingerprint newServer) throws IOException {
    file.write((newServer + "\n").getBytes(StandardCharsets.US_ASCII));
    server = newServer;
  }
}
