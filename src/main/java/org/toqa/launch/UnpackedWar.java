package org.toqa.launch;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.URL;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Enumeration;
import java.util.List;
import java.util.jar.JarEntry;
import java.util.jar.JarFile;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * The folder with a WAR's files. For each WAR the cache has one folder, and in it one for each
 * version, named by the WAR's size and time. The process that uses a version holds a shared lock on
 * it until it ends; whoever unpacks a new version removes those that nobody holds.
 */
final class UnpackedWar {
  /** Kept reachable: a channel that is collected is closed, and its lock with it. */
  private static final List<FileChannel> LOCKS_UNTIL_EXIT = new ArrayList<>();

  private final Path folder;

  private UnpackedWar(Path folder) {
    this.folder = folder;
  }

  static UnpackedWar of(Path war, Path cache) throws IOException {
    Path versions =
        Files.createDirectories(cache.resolve(Integer.toHexString(war.toString().hashCode())));
    String version = Files.size(war) + "-" + Files.getLastModifiedTime(war).toMillis();
    Path folder = versions.resolve(version);
    try (FileChannel guard = openLock(versions.resolve("unpack.lock"))) {
      guard.lock();
      lockUntilExit(folder);
      if (!Files.isDirectory(folder)) {
        Path part = versions.resolve(version + ".part");
        delete(part);
        extract(war, part);
        Files.move(part, folder, StandardCopyOption.ATOMIC_MOVE);
        removeUnused(versions, folder);
      }
      return new UnpackedWar(folder);
    }
  }

  Path folder() {
    return folder;
  }

  /** Its classes, its libraries, and those of the embedded server. */
  URL[] classPath() throws IOException {
    List<Path> paths = new ArrayList<>();
    paths.add(folder.resolve("WEB-INF/classes"));
    paths.addAll(children(folder.resolve("WEB-INF/lib")));
    paths.addAll(children(folder.resolve("WEB-INF/server")));
    URL[] urls = new URL[paths.size()];
    for (int i = 0; i < urls.length; i++) {
      urls[i] = paths.get(i).toUri().toURL();
    }
    return urls;
  }

  private static void extract(Path war, Path target) throws IOException {
    try (JarFile jar = new JarFile(war.toFile())) {
      for (Enumeration<JarEntry> entries = jar.entries(); entries.hasMoreElements(); ) {
        JarEntry entry = entries.nextElement();
        if (entry.isDirectory()) {
          continue;
        }
        Path file = target.resolve(entry.getName());
        Files.createDirectories(file.getParent());
        try (InputStream in = jar.getInputStream(entry);
            OutputStream out = Files.newOutputStream(file)) {
          in.transferTo(out);
        }
      }
    }
  }

  private static void removeUnused(Path versions, Path used) throws IOException {
    for (Path other : children(versions)) {
      if (other.equals(used) || !Files.isDirectory(other)) {
        continue;
      }
      try (FileChannel channel = openLock(lockFile(other))) {
        if (channel.tryLock() != null) {
          delete(other);
          Files.delete(lockFile(other));
        }
      }
    }
  }

  private static void lockUntilExit(Path version) throws IOException {
    FileChannel channel = openLock(lockFile(version));
    channel.lock(0, Long.MAX_VALUE, true);
    LOCKS_UNTIL_EXIT.add(channel);
  }

  private static Path lockFile(Path version) {
    return version.resolveSibling(version.getFileName() + ".lock");
  }

  private static FileChannel openLock(Path file) throws IOException {
    return FileChannel.open(
        file, StandardOpenOption.CREATE, StandardOpenOption.READ, StandardOpenOption.WRITE);
  }

  private static List<Path> children(Path folder) throws IOException {
    try (Stream<Path> paths = Files.list(folder)) {
      return paths.sorted().collect(Collectors.toList());
    }
  }

  private static void delete(Path folder) throws IOException {
    if (!Files.exists(folder)) {
      return;
    }
    try (Stream<Path> paths = Files.walk(folder)) {
      for (Path path : paths.sorted(Comparator.reverseOrder()).collect(Collectors.toList())) {
        Files.delete(path);
      }
    }
  }
}
