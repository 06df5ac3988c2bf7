package org.toqa.web.input;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskOrder.StopOrder;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.geometry.Vec2;
import org.toqa.mission.ArmHandling;
import org.toqa.mission.Stop;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TransportTask;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/** Writes an order as {@link TaskOrderReader} reads it from JSON; its deadline is left out. */
public final class TaskOrderJson {
  private static final JsonNodeFactory NODES = JsonNodeFactory.instance;

  private TaskOrderJson() {}

  public static ObjectNode write(TaskOrder order) {
    ObjectNode json = NODES.objectNode();
    json.put("name", order.name());
    if (order.isDrive()) {
      json.put("kind", order.kind().name());
    } else {
      json.put("load", order.load());
    }
    if (order.stops().isEmpty()) {
      json.set("start", place(order.start()));
      json.set("goal", place(order.goal()));
    } else {
      ArrayNode stops = json.putArray("stops");
      order.stops().forEach(stop -> stops.add(stop(stop)));
    }
    if (order.floor() != null) {
      json.put("floor", order.floor());
    }
    if (order.priority() != 0) {
      json.put("priority", order.priority());
    }
    if (order.size() != null) {
      json.putObject("size")
          .put("length", order.size().length())
          .put("width", order.size().width());
    }
    if (!order.onlyRobots().isEmpty()) {
      ArrayNode robots = json.putArray("onlyRobots");
      order.onlyRobots().forEach(robots::add);
    }
    arm(json, order.arm());
    return json;
  }

  /** The order of that task. */
  public static ObjectNode write(TransportTask task) {
    List<StopOrder> stops =
        task.stops().stream()
            .map(
                stop ->
                    new StopOrder(
                        where(stop), stop.awaitsPerson(), stop.waitTime(), until(stop.charge())))
            .toList();
    return write(
        new TaskOrder(
            task.name(),
            task.load(),
            where(task.start()),
            where(task.goal()),
            task.floor(),
            task.priority(),
            null,
            task.size(),
            task.onlyRobots(),
            stops,
            task.arm()));
  }

  private static Where where(Stop stop) {
    Stop.Charge charge = stop.charge();
    return charge == null ? where(stop.place()) : new Where.Charger(charge.charger());
  }

  private static @Nullable Double until(Stop.@Nullable Charge charge) {
    return charge == null ? null : charge.until();
  }

  private static Where where(TaskPlace place) {
    return place.station() == null
        ? new Where.Point(place.position())
        : new Where.Station(place.station());
  }

  /** A station or coordinates; of a charging point nothing. */
  static ObjectNode place(Where where) {
    ObjectNode json = NODES.objectNode();
    return switch (where) {
      case Where.Station(String name) -> json.put("station", name);
      case Where.Point(Vec2 at) -> json.put("x", at.x()).put("y", at.y());
      case Where.Charger _ -> json;
    };
  }

  private static ObjectNode stop(StopOrder stop) {
    ObjectNode json = place(stop.where());
    if (stop.where() instanceof Where.Charger(String charger)) {
      ObjectNode charge = json.putObject("charge");
      if (charger != null) {
        charge.put("charger", charger);
      }
      if (stop.until() != null) {
        charge.put("until", stop.until());
      }
    }
    if (stop.awaitsPerson()) {
      json.put("waitForPerson", true);
    }
    if (stop.waitTime() != null) {
      json.put("waitSeconds", stop.waitTime().toSeconds());
    }
    return json;
  }

  private static void arm(ObjectNode json, @Nullable ArmHandling arm) {
    if (arm != null) {
      ObjectNode places = json.putObject("arm");
      places.putObject("pick").put("x", arm.pick().x()).put("y", arm.pick().y());
      places.putObject("place").put("x", arm.place().x()).put("y", arm.place().y());
    }
  }
}
