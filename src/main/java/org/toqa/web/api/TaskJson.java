package org.toqa.web.api;

import com.fasterxml.jackson.annotation.JsonInclude;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.ExpectedTimes;
import org.toqa.fleet.NegotiationEntry;
import org.toqa.fleet.TaskView;
import org.toqa.mission.ArmHandling;
import org.toqa.mission.OrderPart;
import org.toqa.mission.Question;
import org.toqa.mission.Stop;
import org.toqa.mission.StopState;
import org.toqa.mission.TaskKind;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TaskState;
import org.toqa.mission.TransportTask;
import org.toqa.wording.Sentence;

/**
 * A task on the wire.
 *
 * @param load kilograms; 0 of a drive without one
 * @param arm null: no arm picks it up
 * @param loadAt where the load is if that is neither its start nor its goal
 * @param blocked whether it waits for what will not come by itself
 * @param expected when it will be picked up and delivered; null: nothing is said of it
 * @param order which part of an order it is
 * @param stops all of its way, the start first and the goal last
 * @param onlyRobots those that may carry it; empty: whichever there are
 * @param followed whether the caller follows it; left out of lists and of the live stream
 * @param history left out there too
 * @param negotiation what was last said of it by robots' agents; left out there too
 */
public record TaskJson(
    long id,
    String name,
    TaskKind kind,
    double load,
    PlaceJson start,
    PlaceJson goal,
    String floor,
    int priority,
    @Nullable Instant deadline,
    TransportTask.@Nullable LoadSize size,
    @Nullable ArmHandling arm,
    String user,
    Instant createdAt,
    Instant changedAt,
    TaskState state,
    boolean held,
    List<String> robots,
    @Nullable PlaceJson loadAt,
    @Nullable Sentence waitingFor,
    boolean blocked,
    @Nullable Sentence late,
    @Nullable Question needs,
    @Nullable ExpectedTimes expected,
    @Nullable OrderPartJson order,
    List<String> onlyRobots,
    List<StopJson> stops,
    @JsonInclude(JsonInclude.Include.NON_NULL) @Nullable Boolean followed,
    @JsonInclude(JsonInclude.Include.NON_NULL) @Nullable List<EventJson> history,
    @JsonInclude(JsonInclude.Include.NON_NULL) @Nullable List<LineJson> negotiation) {

  /** Metres, map frame. */
  record PlaceJson(double x, double y, @Nullable String station) {
    static PlaceJson of(TaskPlace place) {
      return new PlaceJson(place.position().x(), place.position().y(), place.station());
    }
  }

  /**
   * @param waitSeconds after its robots have come; null: nothing but a person is waited for there
   * @param charge how its robot charges there; null: it is no charging point
   * @param since when they came, where they wait there; else null
   */
  record StopJson(
      double x,
      double y,
      @Nullable String station,
      boolean waitForPerson,
      @Nullable Long waitSeconds,
      Stop.@Nullable Charge charge,
      StopState state,
      @Nullable Instant since) {
    static StopJson of(TaskView.StopView view) {
      TaskPlace place = view.stop().place();
      Duration wait = view.stop().waitTime();
      return new StopJson(
          place.position().x(),
          place.position().y(),
          place.station(),
          view.stop().awaitsPerson(),
          wait == null ? null : Long.valueOf(wait.toSeconds()),
          view.stop().charge(),
          view.state(),
          view.since());
    }
  }

  /**
   * @param part its position, from 1
   * @param parts how many there are
   */
  record OrderPartJson(long id, String name, int part, int parts) {
    static @Nullable OrderPartJson of(@Nullable OrderPart part) {
      return part == null
          ? null
          : new OrderPartJson(part.order(), part.name(), part.position(), part.count());
    }
  }

  record EventJson(Instant at, String kind, @Nullable String robot, String who, Sentence text) {
    static EventJson of(EventRecord event) {
      return new EventJson(event.at(), event.kind(), event.robot(), event.who(), event.sentence());
    }
  }

  record LineJson(Instant at, Sentence text) {
    static LineJson of(NegotiationEntry line) {
      return new LineJson(line.at(), line.text());
    }
  }

  public static TaskJson of(TaskView view) {
    return of(view, null, null, null);
  }

  static TaskJson withHistory(
      TaskView view,
      boolean followed,
      List<EventRecord> history,
      List<NegotiationEntry> negotiation) {
    return of(
        view,
        followed,
        history.stream().map(EventJson::of).toList(),
        negotiation.stream().map(LineJson::of).toList());
  }

  private static TaskJson of(
      TaskView view,
      @Nullable Boolean followed,
      @Nullable List<EventJson> history,
      @Nullable List<LineJson> negotiation) {
    TransportTask task = view.task();
    return new TaskJson(
        task.id(),
        task.name(),
        task.kind(),
        task.load(),
        PlaceJson.of(task.start()),
        PlaceJson.of(task.goal()),
        task.floor(),
        task.priority(),
        task.deadline(),
        task.size(),
        task.arm(),
        task.user(),
        task.createdAt(),
        view.changedAt(),
        view.state(),
        view.held(),
        view.robots(),
        view.loadAt() == null ? null : PlaceJson.of(view.loadAt()),
        view.waitingFor(),
        view.blocked(),
        view.late(),
        view.needs(),
        view.expected(),
        OrderPartJson.of(task.part()),
        task.onlyRobots(),
        view.stops().stream().map(StopJson::of).toList(),
        followed,
        history,
        negotiation);
  }
}
