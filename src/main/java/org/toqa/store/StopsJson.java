package org.toqa.store;

import com.fasterxml.jackson.annotation.JsonInclude;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.TaskOrder.StopOrder;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.geometry.Vec2;
import org.toqa.mission.Stop;
import org.toqa.mission.StopProgress;
import org.toqa.mission.TaskPlace;
import tools.jackson.databind.json.JsonMapper;

/** The stops of a task in one column; null where it goes from start to goal without a wait. */
final class StopsJson {
  private static final JsonMapper MAPPER = JsonMapper.builder().build();

  private StopsJson() {}

  /**
   * @param x metres, map frame; null where the station alone was given
   * @param y like {@code x}
   * @param station null: it was given by coordinates
   * @param person whether a person is waited for
   * @param seconds that are waited; null: none
   * @param charges whether the robot charges there; null: it does not
   * @param charger its charging point; null: the robot chooses, or does not charge
   * @param until as far as it charges, of 0 to 1; null: nobody said
   * @param fetchedBefore whether the load on board went there first from where it had been set
   *     down; null: it did not
   */
  private record Entry(
      @Nullable Double x,
      @Nullable Double y,
      @Nullable String station,
      boolean person,
      @Nullable Long seconds,
      @Nullable Boolean charges,
      @Nullable String charger,
      @Nullable Double until,
      @JsonInclude(JsonInclude.Include.NON_NULL) @Nullable Boolean fetchedBefore) {

    boolean isCharging() {
      return Boolean.TRUE.equals(charges);
    }

    Stop.@Nullable Charge charge() {
      return isCharging() ? new Stop.Charge(charger, until) : null;
    }

    Where where() {
      if (isCharging()) {
        return new Where.Charger(charger);
      }
      return station == null ? new Where.Point(position()) : new Where.Station(station);
    }

    Vec2 position() {
      return new Vec2(Objects.requireNonNull(x), Objects.requireNonNull(y));
    }

    @Nullable Duration waitTime() {
      return seconds == null ? null : Duration.ofSeconds(seconds);
    }
  }

  private static @Nullable Long seconds(@Nullable Duration wait) {
    return wait == null ? null : Long.valueOf(wait.toSeconds());
  }

  /**
   * @param fetchedBefore as in {@link StopProgress}
   */
  static @Nullable String write(List<Stop> stops, int fetchedBefore) {
    return json(
        IntStream.range(0, stops.size())
            .mapToObj(i -> entry(stops.get(i), (i > 1 && i == fetchedBefore) ? true : null))
            .toList());
  }

  static @Nullable String writeOrder(List<StopOrder> stops) {
    return json(stops.stream().map(StopsJson::entry).toList());
  }

  private static Entry entry(Stop stop, @Nullable Boolean fetchedBefore) {
    Stop.Charge charge = stop.charge();
    return new Entry(
        stop.place().position().x(),
        stop.place().position().y(),
        stop.place().station(),
        stop.awaitsPerson(),
        seconds(stop.waitTime()),
        charge == null ? null : true,
        charge == null ? null : charge.charger(),
        charge == null ? null : charge.until(),
        fetchedBefore);
  }

  private static Entry entry(StopOrder stop) {
    boolean person = stop.awaitsPerson();
    Long seconds = seconds(stop.waitTime());
    return switch (stop.where()) {
      case Where.Station(String name) ->
          new Entry(null, null, name, person, seconds, null, null, null, null);
      case Where.Point(Vec2 at) ->
          new Entry(at.x(), at.y(), null, person, seconds, null, null, null, null);
      case Where.Charger(String name) ->
          new Entry(null, null, null, person, seconds, true, name, stop.until(), null);
    };
  }

  private static @Nullable String json(List<Entry> entries) {
    return entries.isEmpty() ? null : MAPPER.writeValueAsString(entries);
  }

  static List<Stop> read(@Nullable String json) {
    return entries(json).stream()
        .map(
            entry ->
                new Stop(
                    new TaskPlace(entry.position(), entry.station()),
                    entry.person(),
                    entry.waitTime(),
                    entry.charge()))
        .toList();
  }

  /** As it was written. */
  static int readFetchedBefore(@Nullable String json) {
    List<Entry> entries = entries(json);
    return IntStream.range(0, entries.size())
        .filter(i -> entries.get(i).fetchedBefore() != null)
        .findFirst()
        .orElse(StopProgress.START.fetchedBefore());
  }

  static List<StopOrder> readOrder(@Nullable String json) {
    return entries(json).stream()
        .map(entry -> new StopOrder(entry.where(), entry.person(), entry.waitTime(), entry.until()))
        .toList();
  }

  private static List<Entry> entries(@Nullable String json) {
    return json == null ? List.of() : Arrays.asList(MAPPER.readValue(json, Entry[].class));
  }
}
