package org.toqa.agent.storage;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.link.message.AgentMessage.Fault;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.DeserializationFeature;
import tools.jackson.databind.json.JsonMapper;

/**
 * What outlives the daemon's process: one small file that is replaced as a whole, so that it is
 * always the old entry or the new one. An entry that could not be written is not taken.
 *
 * <p>{@link #save} outlives the process; it does not wait for the disk, so that it may be called
 * while the robot drives. {@link #saveDurably} outlives a loss of power too.
 */
public final class Journal {

  private static final Logger log = LoggerFactory.getLogger(Journal.class);
  private static final JsonMapper MAPPER =
      JsonMapper.builder()
          .disable(DeserializationFeature.FAIL_ON_NULL_FOR_PRIMITIVES) // fields came to be later
          .build();

  private final Path file;
  private final Path next;

  private Optional<JournalEntry> entry;
  private @Nullable Fault fault;

  /**
   * Reads what an earlier daemon wrote into the folder. What is not a journal is put aside.
   *
   * @throws IOException when the folder cannot be read or written
   */
  public Journal(Path folder) throws IOException {
    file = folder.resolve("journal.json");
    next = folder.resolve("journal.json.next");
    entry = read();
  }

  /** The last entry; empty if there is none, or none that can be read. */
  public Optional<JournalEntry> entry() {
    return entry;
  }

  /** Why the last entry could not be written; empty if it could. */
  public Optional<Fault> fault() {
    return Optional.ofNullable(fault);
  }

  /** Whether the entry is written now, so that it outlives the process. */
  public boolean save(JournalEntry newEntry) {
    return write(newEntry, false);
  }

  /** Whether the entry is written now, so that it outlives a loss of power. */
  public boolean saveDurably(JournalEntry newEntry) {
    return write(newEntry, true);
  }

  private boolean write(JournalEntry newEntry, boolean force) {
    try {
      replace(newEntry, force);
      entry = Optional.of(newEntry);
      fault = null;
      return true;
    } catch (IOException e) {
      if (fault == null) {
        log.error("The journal {} cannot be written.", file, e);
      }
      fault = new Fault("JOURNAL", "The journal cannot be written: " + e.getMessage());
      return false;
    }
  }

  private Optional<JournalEntry> read() throws IOException {
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

  private void replace(JournalEntry newEntry, boolean force) throws IOException {
    try (FileChannel channel =
        FileChannel.open(
            next,
            StandardOpenOption.CREATE,
            StandardOpenOption.TRUNCATE_EXISTING,
            StandardOpenOption.WRITE)) {
      ByteBuffer json = ByteBuffer.wrap(MAPPER.writeValueAsBytes(newEntry));
      while (json.hasRemaining()) {
        channel.write(json);
      }
      if (force) {
        channel.force(true);
      }
    }
    Files.move(next, file, StandardCopyOption.ATOMIC_MOVE);
    if (force) {
      try (FileChannel folder = FileChannel.open(file.toAbsolutePath().getParent())) {
        folder.force(true);
      }
    }
  }
}
