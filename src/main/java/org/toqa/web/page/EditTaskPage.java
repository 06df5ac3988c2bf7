package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletRequestWrapper;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.math.BigDecimal;
import java.time.Instant;
import java.time.ZoneOffset;
import java.time.format.DateTimeFormatter;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.CheckRefusedException;
import org.toqa.fleet.TaskView;
import org.toqa.mission.ArmHandling;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TransportTask;
import org.toqa.web.FleetAnswers;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.TaskOrderReader;
import org.toqa.web.input.Version;

/** Edits what is ordered of a task that waits, in the form in which it was ordered. */
public final class EditTaskPage extends PageHandler {
  private static final DateTimeFormatter ENTERED =
      DateTimeFormatter.ofPattern("uuuu-MM-dd'T'HH:mm").withZone(ZoneOffset.UTC);

  public static void show(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<TaskView> task = TaskPage.changeableTask(request, response);
    if (task.isPresent() && !task.get().task().stops().isEmpty()) {
      redirect(request, response, "/tasks/" + task.get().id()); // the form has no stops
    } else if (task.isPresent()) {
      HttpServletRequest filled =
          new Filled(request, entries(task.get().task()), task.get().task().onlyRobots());
      filled.setAttribute("deadlineInUtc", filled.getParameter("deadline"));
      addAttributes(filled, task.get());
      show(filled, response, "new-task");
    }
  }

  public static void submit(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<TaskView> task = TaskPage.changeableTask(request, response);
    if (task.isEmpty()) {
      return;
    }
    if (!task.get().task().stops().isEmpty()) {
      redirect(request, response, "/tasks/" + task.get().id()); // the form has no stops
      return;
    }
    addAttributes(request, task.get());
    FieldErrors differences = differences(task.get().task(), request, Version.ofOrder(task.get()));
    if (!differences.isEmpty()) {
      showConflict(request, response, "new-task", differences);
      return;
    }
    FieldErrors errors = new FieldErrors();
    try {
      if (edit(task.get(), request, errors).isPresent()) {
        redirect(request, response, "/tasks/" + task.get().id());
      } else {
        showAgain(request, response, "new-task", errors);
      }
    } catch (CheckRefusedException e) {
      showRefused(request, response, "new-task", FORM, e);
    }
  }

  private static Optional<TaskView> edit(
      TaskView task, HttpServletRequest request, FieldErrors errors) {
    Instant now = services(request).clock().instant();
    TransportTask seen = request.getParameter("version") == null ? null : task.task();
    return readForm(
            request,
            errors,
            fields -> TaskOrderReader.readEdited(fields, now, task.task().deadline()))
        .flatMap(
            order ->
                acceptedValue(
                    request,
                    FleetAnswers.await(
                        services(request)
                            .fleet()
                            .editTask(task.id(), order, seen, Caller.of(request).name())),
                    errors));
  }

  /** A sentence where another has edited it since the form was filled, and none otherwise. */
  private static FieldErrors differences(
      TransportTask task, HttpServletRequest request, Version stored) {
    EditConflict conflict = new EditConflict(request, stored);
    FieldErrors differences =
        conflict
            .compareText("name", task.name(), "")
            .compareNumber("load", task.load(), String.valueOf(task.load()))
            .differences();
    if (conflict.isStale()) {
      Texts texts = Texts.of(request);
      Map<String, String> now = entries(task);
      for (String end : List.of("start", "goal")) {
        if (!Stream.of("Station", "X", "Y")
            .allMatch(
                part -> Objects.equals(now.get(end + part), request.getParameter(end + part)))) {
          TaskPlace place = end.equals("start") ? task.start() : task.goal();
          differences.add(end, texts.get("error.changed.now", texts.text(place.sentence())));
        }
      }
      if (!differences.sentences().containsKey(FORM)) {
        differences.add(FORM, conflict.text("error.changed"));
      }
    }
    return differences;
  }

  private static void addAttributes(HttpServletRequest request, TaskView task) {
    NewTaskPage.addFloorAttributes(request);
    request.setAttribute("task", task);
    request.setAttribute("version", Version.ofOrder(task));
  }

  /** What the form's fields are filled with; the deadline in UTC. */
  private static Map<String, String> entries(TransportTask task) {
    Map<String, String> entries = new HashMap<>();
    entries.put("name", task.name());
    entries.put("load", number(task.load()));
    entries.put("floor", task.floor());
    entries.put("priority", String.valueOf(task.priority()));
    Instant deadline = task.deadline();
    entries.put("deadline", deadline == null ? "" : ENTERED.format(deadline));
    TransportTask.LoadSize size = task.size();
    entries.put("length", size == null ? "" : number(size.length()));
    entries.put("width", size == null ? "" : number(size.width()));
    ArmHandling arm = task.arm();
    entries.put("pickX", arm == null ? "" : number(arm.pick().x()));
    entries.put("pickY", arm == null ? "" : number(arm.pick().y()));
    entries.put("placeX", arm == null ? "" : number(arm.place().x()));
    entries.put("placeY", arm == null ? "" : number(arm.place().y()));
    addPlace(entries, "start", task.start());
    addPlace(entries, "goal", task.goal());
    return entries;
  }

  private static void addPlace(Map<String, String> entries, String end, TaskPlace place) {
    boolean isStation = place.station() != null;
    entries.put(end + "Station", isStation ? place.station() : "");
    entries.put(end + "X", isStation ? "" : number(place.position().x()));
    entries.put(end + "Y", isStation ? "" : number(place.position().y()));
  }

  private static String number(double value) {
    return BigDecimal.valueOf(value).stripTrailingZeros().toPlainString();
  }

  /** A request with entries for fields that it does not name. */
  private static final class Filled extends HttpServletRequestWrapper {
    private final Map<String, String> entries;
    private final List<String> onlyRobots;

    Filled(HttpServletRequest request, Map<String, String> entries, List<String> onlyRobots) {
      super(request);
      this.entries = entries;
      this.onlyRobots = onlyRobots;
    }

    @Override
    public String @Nullable [] getParameterValues(String name) {
      return name.equals("onlyRobots")
          ? onlyRobots.toArray(String[]::new)
          : super.getParameterValues(name);
    }

    @Override
    public @Nullable String getParameter(String name) {
      String given = super.getParameter(name);
      return given == null ? entries.get(name) : given;
    }
  }
}
