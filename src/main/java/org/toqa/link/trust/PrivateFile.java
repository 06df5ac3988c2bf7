package org.toqa.link.trust;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Collections;
import java.util.Optional;
import java.util.Set;

/**
 * A file that only its owner may read and write (0600 where the machine knows such rights). It is
 * replaced as a whole, and what {@link #write} has written outlives a loss of power.
 */
public final class PrivateFile {

  private static final Set<PosixFilePermission> OWNER_ONLY =
      PosixFilePermissions.fromString("rw-------");

  private final Path path;

  public PrivateFile(Path path) {
    this.path = path;
  }

  /**
   * Its content; empty where there is no such file.
   *
   * @throws IOException with a sentence for people where others may read it too
   */
  public Optional<byte[]> read() throws IOException {
    if (Files.notExists(path)) {
      return Optional.empty();
    }
    if (supportsPosix()
        && !Collections.disjoint(Files.getPosixFilePermissions(path), permissionsOfOthers())) {
      throw new IOException(
          "Others than its owner may read or write %s; make it private (chmod 600), and pair anew if anybody may have read it."
              .formatted(path));
    }
    return Optional.of(Files.readAllBytes(path));
  }

  /**
   * Replaces the file as a whole; it is on the disk when this returns.
   *
   * @throws IOException when it cannot be written; the file has its old content or the new one
   *     then, never a part
   */
  public void write(byte[] content) throws IOException {
    Path next = path.resolveSibling(path.getFileName() + ".next");
    Files.deleteIfExists(next);
    try (FileChannel channel =
        FileChannel.open(
            next,
            Set.of(StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE),
            ownerOnlyAttributes())) {
      ByteBuffer bytes = ByteBuffer.wrap(content);
      while (bytes.hasRemaining()) {
        channel.write(bytes);
      }
      channel.force(true);
    }
    Files.move(next, path, StandardCopyOption.ATOMIC_MOVE);
    try (FileChannel folder = FileChannel.open(path.toAbsolutePath().getParent())) {
      folder.force(true);
    }
  }

  @Override
  public String toString() {
    return path.toString();
  }

  private static Set<PosixFilePermission> permissionsOfOthers() {
    return PosixFilePermissions.fromString("---rwxrwx");
  }

  private static FileAttribute<?>[] ownerOnlyAttributes() {
    return supportsPosix()
        ? new FileAttribute<?>[] {PosixFilePermissions.asFileAttribute(OWNER_ONLY)}
        : new FileAttribute<?>[0];
  }

  private static boolean supportsPosix() {
    return FileSystems.getDefault().supportedFileAttributeViews().contains("posix");
  }
}
