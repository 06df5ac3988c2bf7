package org.toqa.grid;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.zip.ZipEntry;
import java.util.zip.ZipInputStream;
import java.util.zip.ZipOutputStream;
import org.jspecify.annotations.Nullable;

/**
 * The files of a map together, as they are stored, sent and received: of a ROS map its YAML file,
 * its picture and {@code name.floor.yaml}. Packed, it is a ZIP file. Immutable.
 */
public final class MapArchive {
  private static final int MAX_FILES = 16;

  private final Map<String, byte[]> files;

  private MapArchive(Map<String, byte[]> files) {
    this.files = files;
  }

  /**
   * @param files their contents by their names, without folders
   */
  public static MapArchive of(Map<String, byte[]> files) {
    return new MapArchive(new LinkedHashMap<>(files));
  }

  /**
   * Unpacks a ZIP file. Folders are left out, so that it does not matter whether the files or their
   * folder were packed.
   *
   * @throws MapFormatException it is none, or has more or larger files than a map
   */
  public static MapArchive unpack(byte[] zip) throws MapFormatException {
    Map<String, byte[]> files = new LinkedHashMap<>();
    long left = MapLimits.MAX_MAP_BYTES + 2 * MapLimits.MAX_YAML_BYTES;
    try (ZipInputStream in = new ZipInputStream(new ByteArrayInputStream(zip))) {
      for (ZipEntry entry = in.getNextEntry(); entry != null; entry = in.getNextEntry()) {
        if (entry.isDirectory() || isHidden(entry.getName())) {
          continue;
        }
        if (files.size() == MAX_FILES) {
          throw new MapFormatException(
              "The ZIP file has more than " + MAX_FILES + " files; pack those of one map only.");
        }
        byte[] content = in.readNBytes((int) left + 1);
        left -= content.length;
        if (left < 0) {
          throw new MapFormatException(
              "The ZIP file unpacks to more than %d bytes; a map is not so large."
                  .formatted(MapLimits.MAX_MAP_BYTES));
        }
        if (files.put(baseName(entry.getName()), content) != null) {
          throw new MapFormatException(
              "The ZIP file has two files " + baseName(entry.getName()) + "; leave out one.");
        }
      }
    } catch (MapFormatException e) {
      throw e;
    } catch (IOException | IllegalArgumentException e) { // also names that are no text
      throw new MapFormatException("The ZIP file is damaged; pack the map's files again.", e);
    }
    if (files.isEmpty()) {
      throw new MapFormatException("It is no ZIP file, or an empty one; pack the map's files.");
    }
    return new MapArchive(files);
  }

  private static boolean isHidden(String path) {
    return path.startsWith("__MACOSX/") || baseName(path).startsWith(".");
  }

  private static String baseName(String path) {
    return path.substring(Math.max(path.lastIndexOf('/'), path.lastIndexOf('\\')) + 1);
  }

  /** A ZIP file; the same bytes for the same files. */
  public byte[] pack() {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ZipOutputStream out = new ZipOutputStream(bytes)) {
      for (Map.Entry<String, byte[]> file : files.entrySet()) {
        ZipEntry entry = new ZipEntry(file.getKey());
        entry.setLastModifiedTime(FileTime.fromMillis(315_532_800_000L)); // the first that it knows
        out.putNextEntry(entry);
        out.write(file.getValue());
        out.closeEntry();
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return bytes.toByteArray();
  }

  /**
   * Writes the files into a folder.
   *
   * @throws IOException one of them cannot be written
   */
  public void writeTo(Path folder) throws IOException {
    for (Map.Entry<String, byte[]> file : files.entrySet()) {
      Files.write(folder.resolve(file.getKey()), file.getValue());
    }
  }

  boolean has(String name) {
    return files.containsKey(name);
  }

  byte @Nullable [] content(String name) {
    return files.get(name);
  }

  /** The file to read the map from: a ROS map's YAML file, or a MovingAI map. */
  MapFile main() throws MapFormatException {
    List<String> mains = new ArrayList<>();
    for (String name : files.keySet()) {
      String lower = name.toLowerCase(Locale.ROOT);
      boolean isYaml = lower.endsWith(".yaml") || lower.endsWith(".yml");
      if (lower.endsWith(".map") || (isYaml && !isAddition(name))) {
        mains.add(name);
      }
    }
    if (mains.size() != 1) {
      throw new MapFormatException(
          mains.isEmpty()
              ? "No map is among the files: give its .yaml file (ROS map_server) with its picture, or"
                  + " its .map file (MovingAI)."
              : "There are several maps among the files: "
                  + String.join(", ", mains)
                  + "; give one.");
    }
    return new MapFile.InArchive(this, mains.getFirst());
  }

  /** Whether a file only adds to a map; not so where another one adds to it. */
  private boolean isAddition(String name) {
    return name.toLowerCase(Locale.ROOT).endsWith(FloorReader.FLOOR_FILE)
        && !FloorReader.floorFile(new MapFile.InArchive(this, name)).exists();
  }
}
