package org.toqa.grid;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;

/**
 * One of the files that a map is made of, on a disk or in an archive. As a text it is what messages
 * call it.
 */
sealed interface MapFile {
  /** A character for each of its bytes. */
  String BYTE_ORDER_MARK = "\u00EF\u00BB\u00BF";

  /** What it is called, without folders. */
  String name();

  /** The file of that name beside it, whether or not there is one. */
  MapFile sibling(String name);

  boolean exists();

  /**
   * All of it.
   *
   * @param limit bytes that it may have
   */
  byte[] read(long limit) throws MapFormatException;

  /**
   * The lines of a text, a character for each byte, without the byte order mark that editors put
   * before UTF-8.
   *
   * @param limit bytes that it may have
   */
  default List<String> readLines(long limit) throws MapFormatException {
    String text = new String(read(limit), StandardCharsets.ISO_8859_1);
    return (text.startsWith(BYTE_ORDER_MARK) ? text.substring(BYTE_ORDER_MARK.length()) : text)
        .lines()
        .toList();
  }

  static MapFile of(Path path) {
    return new OnDisk(path);
  }

  private static MapFormatException missing(MapFile file, Throwable cause) {
    return new MapFormatException("There is no file " + file + "; check the map's path.", cause);
  }

  private static void checkLength(MapFile file, long length, long limit) throws MapFormatException {
    if (length > limit) {
      throw new MapFormatException(
          "%s has %d bytes, more than the %d that a map file may have."
              .formatted(file, length, limit));
    }
  }

  record OnDisk(Path path) implements MapFile {
    @Override
    public String name() {
      Path name = path.getFileName();
      return name == null ? "" : name.toString();
    }

    @Override
    public MapFile sibling(String other) {
      return new OnDisk(path.resolveSibling(other));
    }

    @Override
    public boolean exists() {
      return Files.exists(path);
    }

    @Override
    public byte[] read(long limit) throws MapFormatException {
      try {
        checkLength(this, Files.size(path), limit);
        return Files.readAllBytes(path);
      } catch (NoSuchFileException e) {
        throw missing(this, e);
      } catch (MapFormatException e) {
        throw e;
      } catch (IOException e) {
        throw new MapFormatException(
            path + " cannot be read; check that it is a file and its permissions.", e);
      }
    }

    @Override
    public String toString() {
      return path.toString();
    }
  }

  record InArchive(MapArchive archive, String name) implements MapFile {
    @Override
    public MapFile sibling(String other) {
      return new InArchive(archive, other);
    }

    @Override
    public boolean exists() {
      return archive.has(name);
    }

    @Override
    public byte[] read(long limit) throws MapFormatException {
      byte[] content = archive.content(name);
      if (content == null) {
        throw new MapFormatException("There is no file " + name + " among those that were given.");
      }
      checkLength(this, content.length, limit);
      return content;
    }

    @Override
    public String toString() {
      return name;
    }
  }
}
