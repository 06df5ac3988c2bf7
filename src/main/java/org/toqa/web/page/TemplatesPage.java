package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import org.toqa.fleet.TaskTemplate;
import org.toqa.grid.FloorMap;
import org.toqa.web.ErrorResponse;
import org.toqa.web.RequestPath;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.TemplateAccess;
import org.toqa.web.input.TemplateCommands;
import org.toqa.web.input.Version;

/** The templates of tasks that the reader may use. */
public final class TemplatesPage extends PageHandler {
  private static final String VIEW = "templates";
  private static final int PAGE_SIZE = 50;

  public static void show(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    addAttributes(request);
    show(request, response, VIEW);
  }

  private static void addAttributes(HttpServletRequest request) {
    Caller caller = Caller.of(request);
    Texts texts = Texts.of(request);
    List<FloorMap> floors = services(request).fleet().floors();
    List<TaskTemplate> templates = TemplateAccess.seenBy(caller, services(request).templates());
    request.setAttribute(
        "entries",
        ListPage.of(request, templates.size(), PAGE_SIZE).of(templates).stream()
            .map(template -> TemplateView.of(template, caller, floors, texts))
            .toList());
  }

  public static void delete(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<TaskTemplate> template = changeable(request, response);
    if (template.isEmpty()) {
      return;
    }
    Texts texts = Texts.of(request);
    Optional<String> refusal =
        new EditConflict(request, Version.of(template.get())).isStale()
            ? Optional.of(texts.get("error.changed"))
            : new TemplateCommands(services(request), texts, Caller.of(request))
                .delete(template.get());
    if (refusal.isEmpty()) {
      redirect(request, response, "/templates?done=deleted");
      return;
    }
    FieldErrors errors = new FieldErrors();
    errors.add(FORM, refusal.get());
    addAttributes(request);
    showConflict(request, response, VIEW, errors);
  }

  /**
   * The template in the path; empty when the answer is given: there is none, or it is another's.
   */
  static Optional<TaskTemplate> changeable(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<TaskTemplate> template = visible(request, response);
    if (template.isPresent() && !TemplateAccess.canChange(Caller.of(request), template.get())) {
      ErrorResponse.send(request, response, 403, Texts.of(request).get("problem.notYourTemplate"));
      return Optional.empty();
    }
    return template;
  }

  /** The template in the path; empty when the answer is given: there is none that he may use. */
  static Optional<TaskTemplate> visible(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<TaskTemplate> template =
        services(request)
            .templates()
            .template(RequestPath.number(request, "id"))
            .filter(one -> TemplateAccess.canSee(Caller.of(request), one));
    if (template.isEmpty()) {
      sendNotFound(request, response, "problem.noSuchTemplate");
    }
    return template;
  }
}
