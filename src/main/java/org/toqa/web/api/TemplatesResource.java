package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Optional;
import org.toqa.fleet.TaskTemplate;
import org.toqa.web.IdempotentSubmitter;
import org.toqa.web.RequestPath;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.FloorQueryReader;
import org.toqa.web.input.TemplateAccess;
import org.toqa.web.input.TemplateCommands;
import org.toqa.web.input.TemplateFiller;
import org.toqa.web.input.TemplateReader;
import org.toqa.web.input.Version;

/** The templates of tasks that the caller may use. */
public final class TemplatesResource extends ApiHandler {

  /** Makes orders from those that the caller may use. */
  static TemplateFiller usable(HttpServletRequest request) {
    return TemplateFiller.of(Caller.of(request), services(request).templates());
  }

  public static void list(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    FloorQueryReader floor = wantedFloor(request);
    Json.send(
        request,
        response,
        200,
        floor
            .filter(
                TemplateAccess.seenBy(Caller.of(request), services(request).templates()),
                TaskTemplate::floor)
            .stream()
            .map(TemplateJson::of)
            .toList());
  }

  public static void get(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    send(request, response, 200, template(request));
  }

  public static void add(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    FieldErrors errors = new FieldErrors();
    TaskTemplate template = read(request, errors);
    Optional<TaskTemplate> added = commands(request).add(template, errors);
    throwIfAny(errors);
    TaskTemplate stored = added.orElseThrow();
    response.setHeader("Location", request.getContextPath() + "/api/v1/templates/" + stored.id());
    send(request, response, HttpServletResponse.SC_CREATED, stored);
  }

  public static void replace(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    TaskTemplate seen = changeable(request);
    requireVersion(Version.of(seen), request);
    FieldErrors errors = new FieldErrors();
    TaskTemplate template = read(request, errors);
    Optional<TaskTemplate> changed = commands(request).replace(seen, template, errors);
    throwIfAny(errors);
    send(request, response, 200, changed.orElseThrow());
  }

  public static void delete(HttpServletRequest request, HttpServletResponse response) {
    TaskTemplate template = changeable(request);
    requireVersion(Version.of(template), request);
    Optional<String> refusal = commands(request).delete(template);
    if (refusal.isPresent()) {
      throw Problem.of(409, refusal.get()).exception();
    }
    response.setStatus(HttpServletResponse.SC_NO_CONTENT);
  }

  private static TaskTemplate read(HttpServletRequest request, FieldErrors errors)
      throws IOException {
    TaskTemplate read =
        TemplateReader.read(
            JsonBody.read(request, errors),
            services(request).fleet().floors(),
            IdempotentSubmitter.orderer(Caller.of(request).account()),
            services(request).clock().instant());
    throwIfAny(errors);
    return read;
  }

  private static TemplateCommands commands(HttpServletRequest request) {
    return new TemplateCommands(services(request), Texts.of(request), Caller.of(request));
  }

  private static TaskTemplate changeable(HttpServletRequest request) {
    TaskTemplate template = template(request);
    if (!TemplateAccess.canChange(Caller.of(request), template)) {
      throw Problem.of(403, Texts.of(request).get("problem.notYourTemplate")).exception();
    }
    return template;
  }

  private static TaskTemplate template(HttpServletRequest request) {
    return services(request)
        .templates()
        .template(RequestPath.number(request, "id"))
        .filter(template -> TemplateAccess.canSee(Caller.of(request), template))
        .orElseThrow(
            () -> Problem.of(404, Texts.of(request).get("problem.noSuchTemplate")).exception());
  }

  private static void send(
      HttpServletRequest request, HttpServletResponse response, int status, TaskTemplate template)
      throws IOException {
    response.setHeader("ETag", Version.of(template).tag());
    Json.send(request, response, status, TemplateJson.of(template));
  }
}
