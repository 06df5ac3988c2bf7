package org.toqa.app.server;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.app.config.Configuration;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.FloorStore;
import org.toqa.grid.FloorMap;
import org.toqa.grid.FloorReader;
import org.toqa.grid.MapFormatException;
import org.toqa.grid.Place;
import org.toqa.persistence.StoreException;
import org.toqa.wording.Phrase;

/** The floors with which a server begins: those of its database, or else of the map files. */
final class FirstFloors {
  private static final Logger log = LoggerFactory.getLogger(FirstFloors.class);

  private FirstFloors() {}

  /**
   * The floors that there are. Where there are none, the maps of the configuration are imported.
   *
   * @throws IOException a map cannot be used, or the floors cannot be stored; the message says what
   *     to do
   */
  static List<FloorMap> of(Configuration configuration, FloorStore store, Instant now)
      throws IOException {
    try {
      List<FloorMap> stored = store.floors();
      if (stored.isEmpty()) {
        List<FloorMap> maps = read(configuration.maps());
        maps.forEach(map -> add(map, store, now));
        return store.floors();
      }
      tellUnused(configuration, stored);
      return stored;
    } catch (StoreException e) {
      throw new IOException("The floors cannot be read or stored: " + e.getMessage(), e);
    }
  }

  /** In a site a station's name means one place. */
  private static List<FloorMap> read(List<Path> files) throws IOException {
    List<FloorMap> maps = new ArrayList<>();
    Map<String, Path> stations = new HashMap<>();
    for (Path file : files) {
      FloorMap map = readMap(file);
      for (Place station : map.stations()) {
        Path other = stations.putIfAbsent(station.name(), file);
        if (other != null) {
          throw new IOException(
              "%s has a station %s, as %s has: give it another name in one of them"
                  .formatted(file, station.name(), other));
        }
      }
      maps.add(map);
    }
    return maps;
  }

  private static FloorMap readMap(Path file) throws MapFormatException {
    try {
      return FloorReader.read(file);
    } catch (MapFormatException e) {
      throw new MapFormatException("map: " + e.getMessage(), e);
    }
  }

  private static void add(FloorMap map, FloorStore store, Instant now) {
    EventRecord event =
        new EventRecord(
            now,
            EventKind.FLOOR_ADDED.text(),
            null,
            null,
            EventRecord.SYSTEM,
            Phrase.FLOOR_IMPORTED.with(map.name()),
            map.name());
    store.addFloor(map, new FloorStore.Change(null, now, List.of(event)));
  }

  /** Whoever names another map now expects it to be used. */
  private static void tellUnused(Configuration configuration, List<FloorMap> stored) {
    for (Path file : configuration.maps()) {
      String name = String.valueOf(file.getFileName()).replaceFirst("\\.[^.]*$", "");
      if (stored.stream().noneMatch(floor -> floor.name().equals(name))) {
        log.warn(
            "{} is not used: the floors are in the database already. Import it on the page Floors.",
            file);
      }
    }
  }
}
