package org.toqa.agent;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.Optional;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.json.JsonMapper;

/**
 * The daemon's memory across its own death: one small file that is replaced as a whole, so that it
 * is always the old entry or the new one.
 *
 * <p>There are two deaths to outlive. {@link #save} outlives the process; it does not wait for the
 * disk, so that it may be called while the robot drives. {@link #secure} outlives a loss of power
 * too.
 */
final class Journal {

  private static final Logger log = LoggerFactory.getLogger(Journal.class);
  private static final JsonMapper MAPPER = JsonMapper.builder().build();

  private final Path file;
  private final Path next;

  Journal(Path folder) {
    file = folder.resolve("journal.json");
    next = folder.resolve("journal.json.next");
  }

  /** The last entry; empty if there is none, or none that can be read. */
  Optional<JournalEntry> read() throws IOException {
    try {
      return Optional.of(MAPPER.readValue(Files.readAllBytes(file), JournalEntry.class));
    } catch (NoSuchFileException e) {
      return Optional.empty();
    } catch (JacksonException e) {
      Path aside = file.resolveSibling("journal.broken");
      Files.move(file, aside, StandardCopyOption.REPLACE_EXISTING);
      log.error(
          "The journal {} cannot be read and was put aside as {}; the robot starts as a new one.",
          file,
          aside.getFileName());
      return Optional.empty();
    }
  }

  void save(JournalEntry entry) throws IOException {
    write(entry, false);
  }

  void secure(JournalEntry entry) throws IOException {
    write(entry, true);
    try (FileChannel folder = FileChannel.open(file.toAbsolutePath().getParent())) {
      folder.force(true);
    }
  }

  private void write(JournalEntry entry, boolean force) throws IOException {
    try (FileChannel channel =
        FileChannel.open(
            next,
            StandardOpenOption.CREATE,
            StandardOpenOption.TRUNCATE_EXISTING,
            StandardOpenOption.WRITE)) {
      ByteBuffer json = ByteBuffer.wrap(MAPPER.writeValueAsBytes(entry));
      while (json.hasRemaining()) {
        channel.write(json);
      }
      if (force) {
        channel.force(true);
      }
    }
    Files.move(next, file, StandardCopyOption.ATOMIC_MOVE);
  }
}
