package org.toqa.web.page;

import java.math.BigDecimal;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;
import org.toqa.mission.Stop;
import org.toqa.mission.TransportTask;

/** What the form of a new task is filled with so that it orders the stops of a task again. */
public final class StopEntries {
  private StopEntries() {}

  /** A field and what is in it. */
  public record Entry(String field, String value) {}

  /**
   * @return empty: the form has no field for what is waited for at one of them, a person and a time
   */
  static Optional<List<Entry>> of(TransportTask task) {
    List<Entry> entries = new ArrayList<>();
    List<Stop> stops = task.stops();
    int first = task.isDrive() ? 1 : 0; // a drive has no start
    for (int i = 0; i < stops.size(); i++) {
      String wait = wait(stops.get(i));
      if (wait == null) {
        return Optional.empty();
      }
      if (first + i > 1) {
        entries.add(new Entry("stopStation", place(stops.get(i))));
        entries.add(new Entry("stopWait", wait));
      } else {
        String end = first + i == 0 ? "start" : "goal";
        addEnd(entries, end, stops.get(i));
        entries.add(new Entry(end + "Wait", wait));
      }
    }
    if (!task.isDrive()) {
      entries.add(new Entry("carriedBy", "one"));
    }
    return Optional.of(entries);
  }

  private static void addEnd(List<Entry> entries, String end, Stop stop) {
    if (stop.charge() == null && stop.place().station() == null) {
      Vec2 at = stop.place().position();
      entries.add(new Entry(end + "X", number(at.x())));
      entries.add(new Entry(end + "Y", number(at.y())));
    } else {
      entries.add(new Entry(end + "Station", place(stop)));
    }
  }

  private static String place(Stop stop) {
    Stop.Charge charge = stop.charge();
    if (charge != null) {
      return charge.charger() == null ? "charge" : "charge@" + charge.charger();
    }
    String station = stop.place().station();
    Vec2 at = stop.place().position();
    return station == null ? number(at.x()) + " " + number(at.y()) : station;
  }

  /** As the form has it; null: it has no such one. */
  private static @Nullable String wait(Stop stop) {
    Duration time = stop.waitTime();
    Double until = stop.charge() == null ? null : stop.charge().until();
    List<String> waits = new ArrayList<>();
    if (stop.awaitsPerson()) {
      waits.add("person");
    }
    if (time != null) {
      waits.add(String.valueOf(time.toSeconds()));
    }
    if (until != null) {
      waits.add(number(until * 100) + "%");
    }
    return waits.size() > 1 ? null : String.join("", waits);
  }

  private static String number(double value) {
    return BigDecimal.valueOf(Math.round(value * 1e6), 6).stripTrailingZeros().toPlainString();
  }
}
