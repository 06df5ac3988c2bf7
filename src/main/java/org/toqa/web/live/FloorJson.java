package org.toqa.web.live;

import java.time.Instant;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FloorView;
import org.toqa.fleet.FloorView.BoxView;
import org.toqa.fleet.FloorView.ChargerShortage;
import org.toqa.fleet.FloorView.FaultyCharger;
import org.toqa.fleet.FloorView.HeldLoad;
import org.toqa.fleet.FloorView.LeftLoad;
import org.toqa.fleet.FloorView.SeenObstacle;
import org.toqa.fleet.FloorView.StandstillView;
import org.toqa.fleet.FloorView.ZoneView;
import org.toqa.geometry.Vec2;
import org.toqa.web.api.HoldJson;
import org.toqa.wording.Sentence;

/**
 * A floor on the wire; the fields are those of {@link FloorView}. Cells are runs as in the map of
 * the API.
 */
record FloorJson(
    String floor,
    @Nullable HoldJson hold,
    List<Integer> obstacles,
    List<KeptJson> kept,
    List<StandstillJson> standstills,
    List<FaultyCharger> faultyChargers,
    List<LeftLoad> leftLoads,
    @Nullable ChargerShortage chargerShortage,
    List<SeenJson> seen,
    List<HeldLoad> heldLoads,
    List<ZoneView> zones,
    String map,
    List<BoxView> boxes) {

  /** An obstacle that robots see or have seen. */
  record SeenJson(
      List<Integer> cells, List<String> robots, Instant since, Instant last, boolean doubted) {
    static SeenJson of(SeenObstacle view) {
      return new SeenJson(
          view.cells().runs(), view.robots(), view.since(), view.last(), view.isDoubted());
    }
  }

  /** Cells that stay reserved for a lost robot. */
  record KeptJson(String robot, List<Integer> cells) {}

  record StandstillJson(List<String> robots, List<Vec2> where, Instant since, Sentence text) {
    static StandstillJson of(StandstillView view) {
      return new StandstillJson(view.robots(), view.positions(), view.since(), view.text());
    }
  }

  static FloorJson of(FloorView view) {
    return new FloorJson(
        view.name(),
        HoldJson.of(view.hold()),
        view.obstacles().runs(),
        view.silentRobotCells().entrySet().stream()
            .map(e -> new KeptJson(e.getKey(), e.getValue().runs()))
            .toList(),
        view.standstills().stream().map(StandstillJson::of).toList(),
        view.faultyChargers(),
        view.leftLoads(),
        view.chargerShortage(),
        view.seen().stream().map(SeenJson::of).toList(),
        view.heldLoads(),
        view.zones(),
        view.map(),
        view.boxes());
  }
}
