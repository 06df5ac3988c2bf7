package org.toqa.agent.access;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.time.Duration;
import java.util.Optional;
import org.toqa.link.trust.IdentityFile;
import org.toqa.link.trust.PairingCode;
import org.toqa.link.trust.PrivateFile;

/**
 * How a daemon that runs is asked to pair: whoever may write into its data folder puts a new code
 * there.
 *
 * <ol>
 *   <li>The asker writes the file {@code pairing.code}.
 *   <li>The daemon looks for it, takes it away, and from then on the code is good.
 *   <li>The asker sees that it is gone, and shows the code.
 * </ol>
 */
public final class PairingRequestFile {

  /** How often a daemon looks. */
  static final Duration POLL_INTERVAL = Duration.ofMillis(500);

  private static final Duration TIMEOUT = POLL_INTERVAL.multipliedBy(10);

  private final Path path;
  private final PrivateFile file;

  PairingRequestFile(Path folder) {
    path = folder.resolve("pairing.code");
    file = new PrivateFile(path);
  }

  /**
   * Asks, and waits until the daemon has taken the code.
   *
   * @param folder of a daemon that runs
   * @return the code, as people read it
   * @throws IOException with a sentence for people
   */
  public static String requestPairing(Path folder) throws IOException, InterruptedException {
    PairingRequestFile request = new PairingRequestFile(folder);
    PairingCode code = PairingCode.of(IdentityFile.open(folder).fingerprint(), new SecureRandom());
    request.file.write(code.text().getBytes(StandardCharsets.US_ASCII));
    long end = System.nanoTime() + TIMEOUT.toNanos();
    while (Files.exists(request.path)) {
      if (System.nanoTime() > end && Files.deleteIfExists(request.path)) {
        throw new IOException(
            "The daemon that runs on %s does not take a new code: its link is not encrypted. Stop it, and start it with --pair."
                .formatted(folder));
      }
      Thread.sleep(POLL_INTERVAL.dividedBy(5));
    }
    return code.text();
  }

  /** The code that somebody has put there since the last look; it is taken away. */
  Optional<PairingCode> take() throws IOException {
    try {
      return file.read()
          .flatMap(code -> PairingCode.parse(new String(code, StandardCharsets.US_ASCII)));
    } finally {
      Files.deleteIfExists(path);
    }
  }
}
