package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.toqa.lab.Experiments;
import org.toqa.lab.record.LabOrder;
import org.toqa.lab.record.LabRun;
import org.toqa.lab.record.Laboratory;
import org.toqa.lab.record.Laboratory.Ordered;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.LabOrderReader;

/** The experiments, a form to start each, and all runs. */
public final class LaboratoryPage extends PageHandler {
  /** More runs do not stand side by side. */
  private static final int MOST_COMPARED = 4;

  public static void show(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    addAttributes(request);
    show(request, response, "laboratory");
  }

  private static void addAttributes(HttpServletRequest request) {
    Laboratory laboratory = services(request).laboratory();
    request.setAttribute("experiments", Experiments.all());
    request.setAttribute("mostKept", Laboratory.MOST_KEPT);
    request.setAttribute(
        "runs",
        laboratory.store().runs().stream().map(run -> LabRunView.of(run, laboratory)).toList());
  }

  public static void start(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    FieldErrors errors = new FieldErrors();
    Optional<LabRun> run =
        readForm(request, errors, LabOrderReader::readForm)
            .flatMap(order -> start(request, order, errors));
    if (run.isPresent()) {
      redirect(request, response, "/laboratory/runs/" + run.get().id());
    } else {
      addAttributes(request);
      showAgain(request, response, "laboratory", errors);
    }
  }

  private static Optional<LabRun> start(
      HttpServletRequest request, LabOrder order, FieldErrors errors) {
    Texts texts = Texts.of(request);
    return switch (services(request).laboratory().start(order, Caller.of(request).name())) {
      case Ordered.Queued(LabRun queued) -> Optional.of(queued);
      case Ordered.QueueFull _ -> {
        errors.add(FORM, texts.get("problem.laboratory.queue", Laboratory.MOST_WAITING));
        yield Optional.empty();
      }
      case Ordered.ArchiveFull _ -> {
        errors.add(FORM, texts.get("problem.laboratory.archive", Laboratory.MOST_KEPT));
        yield Optional.empty();
      }
    };
  }

  /** Runs that are done, side by side. */
  public static void compare(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Laboratory laboratory = services(request).laboratory();
    String[] chosen = Objects.requireNonNullElse(request.getParameterValues("run"), new String[0]);
    List<LabRun> runs =
        Arrays.stream(chosen)
            .filter(id -> id.matches("[1-9][0-9]{0,17}"))
            .distinct()
            .flatMap(id -> laboratory.store().run(Long.parseLong(id)).stream())
            .limit(MOST_COMPARED + 1L)
            .toList();
    if (runs.size() < 2 || runs.size() > MOST_COMPARED) {
      FieldErrors errors = new FieldErrors();
      errors.add(FORM, Texts.of(request).get("error.laboratory.compare", MOST_COMPARED));
      addAttributes(request);
      showAgain(request, response, "laboratory", errors);
      return;
    }
    request.setAttribute("comparison", LabComparison.of(runs, laboratory));
    show(request, response, "lab-comparison");
  }
}
