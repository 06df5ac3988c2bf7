package org.toqa.agent.storage;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import org.jspecify.annotations.Nullable;
import org.toqa.link.trust.PrivateFolder;

/** A daemon's folder, owned by one daemon at a time. */
public final class DataFolder implements AutoCloseable {

  private final Path path;
  private final FileChannel lockFile;

  /**
   * Makes the folder where it is missing, and takes it for this daemon until {@link #close}.
   *
   * @throws DataFolderInUseException if another daemon has it
   * @throws IOException if it cannot be made or written
   */
  public DataFolder(Path path) throws IOException {
    this.path = path;
    PrivateFolder.create(path);
    lockFile =
        FileChannel.open(path.resolve("lock"), StandardOpenOption.CREATE, StandardOpenOption.WRITE);
    if (tryLock() == null) {
      lockFile.close();
      throw new DataFolderInUseException(path);
    }
  }

  /**
   * Whether a daemon runs on it.
   *
   * @throws IOException if that cannot be found out
   */
  public static boolean isInUse(Path path) throws IOException {
    if (Files.notExists(path)) {
      return false;
    }
    try (DataFolder _ = new DataFolder(path)) {
      return false;
    } catch (DataFolderInUseException e) {
      return true;
    }
  }

  public Path path() {
    return path;
  }

  @Override
  public void close() throws IOException {
    lockFile.close(); // and with it the lock
  }

  private @Nullable FileLock tryLock() throws IOException {
    try {
      return lockFile.tryLock();
    } catch (OverlappingFileLockException e) {
      return null;
    }
  }
}
