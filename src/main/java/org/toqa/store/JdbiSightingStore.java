package org.toqa.store;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.jdbi.v3.core.Jdbi;
import org.jdbi.v3.core.statement.PreparedBatch;
import org.toqa.fleet.history.SeenPlaces.Sighting;
import org.toqa.fleet.history.SeenPlaces.Spot;
import org.toqa.fleet.history.SightingStore;

/** Where robots have seen what the map does not show. */
public final class JdbiSightingStore implements SightingStore {
  /** No robot's name has it. */
  private static final String BETWEEN = ",";

  private final SqlExecutor sql;

  public JdbiSightingStore(Jdbi jdbi) {
    this.sql = new SqlExecutor(jdbi);
  }

  @Override
  public Map<Spot, Sighting> sightings() {
    return sql.withHandle(
        h -> {
          Map<Spot, Sighting> found = new HashMap<>();
          h.createQuery("select floor, x, y, first_at, last_at, robots, dismissed from sightings")
              .map(
                  (row, _) ->
                      Map.entry(
                          new Spot(row.getString("floor"), row.getInt("x"), row.getInt("y")),
                          new Sighting(
                              DatabaseTypes.instant(row, "first_at"),
                              DatabaseTypes.instant(row, "last_at"),
                              robots(row.getString("robots")),
                              row.getBoolean("dismissed"))))
              .forEach(entry -> found.put(entry.getKey(), entry.getValue()));
          return found;
        });
  }

  private static Set<String> robots(String names) {
    return Arrays.stream(names.split(BETWEEN, -1))
        .filter(name -> !name.isEmpty())
        .collect(Collectors.toUnmodifiableSet());
  }

  @Override
  public void replace(Map<Spot, Sighting> sightings) {
    sql.inTransaction(
        h -> {
          h.execute("delete from sightings");
          PreparedBatch batch =
              h.prepareBatch(
                  """
                  insert into sightings (floor, x, y, first_at, last_at, robots, dismissed)
                  values (:floor, :x, :y, :first, :last, :robots, :dismissed)
                  """);
          sightings.forEach(
              (spot, sighting) ->
                  batch
                      .bind("floor", spot.floor())
                      .bind("x", spot.x())
                      .bind("y", spot.y())
                      .bind("first", sighting.first())
                      .bind("last", sighting.last())
                      .bind("robots", String.join(BETWEEN, sighting.robots()))
                      .bind("dismissed", sighting.dismissed())
                      .add());
          if (batch.size() > 0) {
            batch.execute();
          }
          return null;
        });
  }
}
