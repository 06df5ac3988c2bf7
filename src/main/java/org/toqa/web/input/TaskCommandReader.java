package org.toqa.web.input;

import org.jspecify.annotations.Nullable;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.fleet.TaskView;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.Place;
import org.toqa.mission.LoadChoice;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.Reply;
import org.toqa.mission.TaskPlace;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** Reads what a person wants of a task, from a form or from the wire. */
public final class TaskCommandReader {
  private final Texts texts;
  private final FieldErrors errors;

  public TaskCommandReader(Texts texts, FieldErrors errors) {
    this.texts = texts;
    this.errors = errors;
  }

  /** A clerk changes his own tasks, an operator all. */
  public static boolean canChange(Caller caller, TaskView task) {
    return caller.mayChangeOrderOf(task.task().owner());
  }

  /**
   * @param load {@code here} or {@code back}; null: nobody said it
   */
  public MissionEvent.Cancel readCancel(Caller caller, @Nullable String load) {
    LoadChoice choice =
        switch (load) {
          case null -> null;
          case "here" -> LoadChoice.HERE;
          case "back" -> LoadChoice.BACK;
          default -> {
            errors.add("load", texts.get("error.cancel.load"));
            yield null;
          }
        };
    return new MissionEvent.Cancel(caller.name(), choice);
  }

  /**
   * It means something only when no error was filed.
   *
   * @param seen the priority that the caller has seen; null where he does not say
   */
  public MissionEvent.Prioritise readPriority(
      Caller caller, @Nullable Double priority, @Nullable Integer seen) {
    return new MissionEvent.Prioritise(
        caller.name(), new InputRules(texts, errors).requiredPriority("priority", priority), seen);
  }

  /**
   * It means something only when no error was filed.
   *
   * @param floor of the task
   */
  public MissionEvent.MoveLoad readMove(Caller caller, Fields fields, FloorMap floor) {
    TaskPlace place =
        switch (fields.place("place")) {
          case Where.Point(Vec2 point) -> new TaskPlace(point, null);
          case Where.Charger _ -> throw new IllegalArgumentException("no load lies there");
          case Where.Station(String name) ->
              floor.stations().stream()
                  .filter(station -> station.name().equals(name))
                  .findFirst()
                  .map(station -> new TaskPlace(station.position(), station.name()))
                  .orElseGet(() -> unknownStation(name, floor));
        };
    return new MissionEvent.MoveLoad(caller.name(), place);
  }

  private TaskPlace unknownStation(String name, FloorMap floor) {
    Sentence known = Sentence.names(floor.stations().stream().map(Place::name).toList());
    errors.add("place", texts.text(Phrase.NO_SUCH_STATION.with(name, known)));
    return new TaskPlace(Vec2.ZERO, null);
  }

  /**
   * It means something only when no error was filed.
   *
   * @param stop the number, from 1, of the stop that the caller has seen; null: he does not say
   */
  public MissionEvent.GoOn readGoOn(Caller caller, @Nullable Double stop) {
    if (stop != null && (stop != Math.rint(stop) || !(stop >= 1 && stop <= TaskOrder.MAX_STOPS))) {
      errors.add("stop", texts.get("error.stop", TaskOrder.MAX_STOPS));
      return new MissionEvent.GoOn(caller.name(), null);
    }
    return new MissionEvent.GoOn(caller.name(), stop == null ? null : stop.intValue() - 1);
  }

  /** It means something only when no error was filed. */
  public MissionEvent.Answer readAnswer(Caller caller, @Nullable String answer) {
    Reply reply =
        Reply.ofWord(answer == null ? "" : answer)
            .orElseGet(
                () -> {
                  errors.add("answer", texts.get("error.answer"));
                  return Reply.WAIT;
                });
    return new MissionEvent.Answer(caller.name(), reply);
  }
}
