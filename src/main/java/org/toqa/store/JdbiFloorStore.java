package org.toqa.store;

import java.time.Instant;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.jdbi.v3.core.Handle;
import org.jdbi.v3.core.Jdbi;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FloorDraft;
import org.toqa.fleet.FloorStore;
import org.toqa.grid.FloorDrawing;
import org.toqa.grid.FloorMap;
import org.toqa.grid.FloorReader;
import org.toqa.grid.FloorWriter;
import org.toqa.grid.MapArchive;
import org.toqa.grid.MapFormatException;
import org.toqa.grid.Margins;
import org.toqa.persistence.StoreException;

/** Floors with their maps, on H2 and on MySQL. */
public final class JdbiFloorStore implements FloorStore {
  private static final String NEWEST_MAP =
      "select files from floor_maps where floor = :floor order by id desc limit 1";

  /** Tables of what a new floor of the same name must not find. */
  private static final List<String> BY_FLOOR =
      List.of(
          "floor_drafts",
          "floor_holds",
          "floor_allocators",
          "sightings",
          "supervisions",
          "explorations");

  private final SqlExecutor sql;
  private final Margins margins;

  /**
   * @param margins that are kept on every floor
   */
  public JdbiFloorStore(Jdbi jdbi, Margins margins) {
    this.sql = new SqlExecutor(jdbi);
    this.margins = margins;
  }

  private static String key(String floor) {
    return floor.toLowerCase(Locale.ROOT);
  }

  @Override
  public List<FloorMap> floors() {
    return sql.withHandle(
        h ->
            h.createQuery("select name from floors order by place").mapTo(String.class).stream()
                .map(name -> mapInForce(h, name))
                .toList());
  }

  private FloorMap mapInForce(Handle h, String floor) {
    return map(floor, h.createQuery(NEWEST_MAP).bind("floor", floor).mapTo(byte[].class).one());
  }

  private FloorMap map(String floor, byte[] files) {
    return new FloorMap(floor, drawing(floor, files), margins);
  }

  private static FloorDrawing drawing(String floor, byte[] files) {
    try {
      return FloorReader.readStored(MapArchive.unpack(files));
    } catch (MapFormatException e) {
      throw new StoreException("The stored map of " + floor + " is damaged: " + e.getMessage(), e);
    }
  }

  private static byte[] files(String floor, FloorDrawing drawing) {
    return FloorWriter.mapServerFiles(floor, drawing).pack();
  }

  @Override
  public boolean addFloor(FloorMap map, Change change) {
    return sql.inTransaction(
        h -> {
          int added =
              h.createUpdate(
                      """
                      insert ignore into floors (name_key, name, place, revision)
                      select :key, :name, coalesce(max(place), 0) + 1, 1 from floors
                      """)
                  .bind("key", key(map.name()))
                  .bind("name", map.name())
                  .execute();
          if (added > 0) {
            addMap(h, map.name(), files(map.name(), map.drawing()), change);
          }
          return added > 0;
        });
  }

  private static void addMap(Handle h, String floor, byte[] files, Change change) {
    h.createUpdate(
            """
            insert into floor_maps (floor, since, user_name, files)
            values (:floor, :since, :user, :files)
            """)
        .bind("floor", floor)
        .bind("since", change.at())
        .bind("user", change.user())
        .bind("files", files)
        .execute();
    EventTable.addMissing(h, change.events());
  }

  @Override
  public void removeFloor(String floor, Change change) {
    sql.inTransaction(
        h -> {
          h.execute("delete from floors where name_key = ?", key(floor));
          BY_FLOOR.forEach(table -> h.execute("delete from " + table + " where floor = ?", floor));
          EventTable.addMissing(h, change.events());
          return null;
        });
  }

  @Override
  public Optional<FloorDraft> draft(String floor) {
    return sql.inTransaction(
        h -> revision(h, floor, "").map(revision -> draft(h, floor, revision)));
  }

  /** Empty: no such floor. */
  private static Optional<Long> revision(Handle h, String floor, String lock) {
    return h.createQuery("select revision from floors where name_key = :key " + lock)
        .bind("key", key(floor))
        .mapTo(Long.class)
        .findOne();
  }

  private record DraftRow(String userName, Instant at, byte[] files) {}

  private FloorDraft draft(Handle h, String floor, long revision) {
    return h.createQuery("select user_name, at, files from floor_drafts where floor = :floor")
        .bind("floor", floor)
        .map(
            (row, context) ->
                new DraftRow(
                    row.getString("user_name"),
                    context
                        .findColumnMapperFor(Instant.class)
                        .orElseThrow()
                        .map(row, "at", context),
                    row.getBytes("files")))
        .findOne()
        .map(
            row ->
                new FloorDraft(
                    floor, revision, drawing(floor, row.files()), row.userName(), row.at()))
        .orElseGet(
            () -> new FloorDraft(floor, revision, mapInForce(h, floor).drawing(), null, null));
  }

  @Override
  public Optional<FloorDraft> saveDraft(
      String floor, FloorDrawing drawing, long seen, String user, Instant at) {
    byte[] files = files(floor, drawing);
    return sql.inTransaction(
        h ->
            advance(h, floor, seen)
                .map(
                    revision -> {
                      h.execute("delete from floor_drafts where floor = ?", floor);
                      h.createUpdate(
                              """
                              insert into floor_drafts (floor, user_name, at, files)
                              values (:floor, :user, :at, :files)
                              """)
                          .bind("floor", floor)
                          .bind("user", user)
                          .bind("at", at)
                          .bind("files", files)
                          .execute();
                      return new FloorDraft(floor, revision, drawing, user, at);
                    }));
  }

  /** The next revision; empty: there is another one by now. */
  private static Optional<Long> advance(Handle h, String floor, @Nullable Long seen) {
    Optional<Long> now = revision(h, floor, "for update");
    if (now.isEmpty() || (seen != null && !now.get().equals(seen))) {
      return Optional.empty();
    }
    h.execute("update floors set revision = revision + 1 where name_key = ?", key(floor));
    return now.map(revision -> revision + 1);
  }

  @Override
  public boolean discardDraft(String floor, @Nullable Long seen) {
    return sql.inTransaction(
        h -> {
          Optional<Long> now = revision(h, floor, "for update");
          if (seen != null && !now.equals(Optional.of(seen))) {
            return false;
          }
          if (h.execute("delete from floor_drafts where floor = ?", floor) > 0) {
            var _ = advance(h, floor, null);
          }
          return true;
        });
  }

  @Override
  public Optional<FloorMap> publish(String floor, long seen, Change change) {
    return sql.inTransaction(
        h ->
            advance(h, floor, seen)
                .flatMap(
                    revision ->
                        h.createQuery("select files from floor_drafts where floor = :floor")
                            .bind("floor", floor)
                            .mapTo(byte[].class)
                            .findOne())
                .map(
                    files -> {
                      addMap(h, floor, files, change);
                      h.execute("delete from floor_drafts where floor = ?", floor);
                      return map(floor, files);
                    }));
  }

  /** What was before the first one is not known: that one is shown. */
  @Override
  public Optional<FloorMap> mapAt(String floor, Instant at) {
    return sql.withHandle(
        h ->
            h.createQuery(
                    """
                    select files from floor_maps where floor = :floor
                    order by case when since <= :at then 0 else 1 end,
                      case when since <= :at then id end desc, id limit 1
                    """)
                .bind("floor", floor)
                .bind("at", at)
                .mapTo(byte[].class)
                .findOne()
                .map(files -> map(floor, files)));
  }
}
