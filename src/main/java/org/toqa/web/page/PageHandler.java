package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Optional;
import java.util.function.Function;
import org.toqa.fleet.Answer;
import org.toqa.fleet.CheckRefusedException;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.mission.Question;
import org.toqa.web.ErrorResponse;
import org.toqa.web.RequestPath;
import org.toqa.web.Services;
import org.toqa.web.Texts;
import org.toqa.web.access.CsrfToken;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.Fields;
import org.toqa.web.input.FloorQueryReader;
import org.toqa.wording.Sentence;

/**
 * What the handlers of the pages have in common. They print nothing; a view under {@code
 * WEB-INF/views} does.
 */
abstract class PageHandler {
  private static final int CONFLICT = 409;
  private static final int UNPROCESSABLE = 422;

  /** The name under which an error of the whole form is filed. */
  static final String FORM = "form";

  static Services services(HttpServletRequest request) {
    return Services.of(request);
  }

  /** Shows a view; it finds the CSRF token for its forms as {@code csrf}. */
  static void show(HttpServletRequest request, HttpServletResponse response, String view)
      throws ServletException, IOException {
    request.setAttribute("csrf", CsrfToken.of(request, response));
    showWithoutForm(request, response, view);
  }

  /** Shows a view that has no form, without giving the browser a cookie for it. */
  static void showWithoutForm(HttpServletRequest request, HttpServletResponse response, String view)
      throws ServletException, IOException {
    Texts.of(request).setContentLanguage(response);
    String path = RequestPath.of(request);
    String query = request.getQueryString();
    request.setAttribute("address", query == null ? path : path + "?" + query);
    FleetSnapshot fleet = services(request).fleet().snapshots().latest();
    request.setAttribute("pause", fleet.pause());
    request.setAttribute("alerts", fleet.alerts());
    request.setAttribute("floors", services(request).fleet().floors());
    request.getRequestDispatcher("/WEB-INF/views/" + view + ".jsp").forward(request, response);
  }

  /** Shows the form again, with what was entered and a sentence at each field at fault. */
  static void showAgain(
      HttpServletRequest request, HttpServletResponse response, String view, FieldErrors errors)
      throws ServletException, IOException {
    showAgain(request, response, view, errors, UNPROCESSABLE);
  }

  /** The same where somebody else has changed meanwhile what the form would change. */
  static void showConflict(
      HttpServletRequest request, HttpServletResponse response, String view, FieldErrors errors)
      throws ServletException, IOException {
    showAgain(request, response, view, errors, CONFLICT);
  }

  /** Shows the form again to who is to send it later: what it orders was not checked. */
  static void showRefused(
      HttpServletRequest request,
      HttpServletResponse response,
      String view,
      String field,
      CheckRefusedException refusal)
      throws ServletException, IOException {
    FieldErrors errors = new FieldErrors();
    errors.add(field, ErrorResponse.sentence(request, refusal));
    showAgain(request, response, view, errors, ErrorResponse.status(response, refusal));
  }

  private static void showAgain(
      HttpServletRequest request,
      HttpServletResponse response,
      String view,
      FieldErrors errors,
      int status)
      throws ServletException, IOException {
    response.setStatus(status);
    request.setAttribute("errors", errors.sentences());
    show(request, response, view);
  }

  /** See other: a reload does not send the form again. */
  static void redirect(HttpServletRequest request, HttpServletResponse response, String path)
      throws IOException {
    response.sendRedirect(request.getContextPath() + path, HttpServletResponse.SC_SEE_OTHER);
  }

  static void sendNotFound(HttpServletRequest request, HttpServletResponse response, String key)
      throws IOException {
    ErrorResponse.send(request, response, 404, Texts.of(request).get(key));
  }

  /** The floor of which a list is wanted; all, with a sentence in the errors, if there is none. */
  static FloorQueryReader wantedFloor(HttpServletRequest request, FieldErrors errors) {
    return new FloorQueryReader(request, errors, services(request).fleet().floors());
  }

  /** Shows a list, with a sentence at each field of its query that is at fault. */
  static void showList(
      HttpServletRequest request, HttpServletResponse response, String view, FieldErrors errors)
      throws ServletException, IOException {
    if (errors.isEmpty()) {
      show(request, response, view);
    } else {
      showAgain(request, response, view, errors);
    }
  }

  /** What a form orders; empty, with a sentence in the errors, where a field is wrong. */
  static <T> Optional<T> readForm(
      HttpServletRequest request, FieldErrors errors, Function<Fields, T> reader) {
    T read = reader.apply(new FormFields(request, errors));
    return errors.isEmpty() ? Optional.of(read) : Optional.empty();
  }

  /** The value, if the fleet said yes; its no is filed under the field it names, or the form. */
  static <T> Optional<T> acceptedValue(
      HttpServletRequest request, Answer<T> answer, FieldErrors errors) {
    Texts texts = Texts.of(request);
    return switch (answer) {
      case Answer.Accepted<T>(T value) -> Optional.of(value);
      case Answer.Rejected<T>(String field, Sentence sentence) ->
          refuse(errors, field == null ? FORM : field, texts.text(sentence));
      case Answer.Conflict<T>(Sentence sentence, Question needs) ->
          refuse(errors, FORM, texts.text(sentence));
      case Answer.Outdated<T>() -> refuse(errors, FORM, texts.get("error.changed"));
      case Answer.Unknown<T>(Sentence sentence) -> refuse(errors, FORM, texts.text(sentence));
    };
  }

  private static <T> Optional<T> refuse(FieldErrors errors, String field, String sentence) {
    errors.add(field, sentence);
    return Optional.empty();
  }
}
