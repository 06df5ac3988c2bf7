package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Map;
import java.util.Optional;
import org.toqa.store.Account;
import org.toqa.store.Accounts;
import org.toqa.store.Role;
import org.toqa.store.Sessions;
import org.toqa.web.Doors;
import org.toqa.web.FieldErrors;
import org.toqa.web.InputRules;
import org.toqa.web.Texts;
import org.toqa.web.UserWishes;
import org.toqa.web.Version;
import org.toqa.web.access.Caller;

/** One user: his sessions and tokens, password and e-mail address, what he may do, and the end. */
public final class UserServlet extends ApiServlet {
  @Override
  protected void doGet(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Account user = user(request);
    if (Doors.lastSegment(request).equals("sessions")) {
      Json.send(
          request,
          response,
          200,
          services().sessions().of(user.id()).stream().map(SessionJson::of).toList());
    } else {
      send(request, response, user);
    }
  }

  private static void send(HttpServletRequest request, HttpServletResponse response, Account user)
      throws IOException {
    response.setHeader("ETag", Version.of(user).tag());
    Json.send(request, response, 200, UserJson.of(user));
  }

  @Override
  protected void doPut(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Account user = user(request);
    refuseOther(Version.of(user), request);
    FieldErrors errors = new FieldErrors();
    JsonFields fields = JsonFields.of(request, errors);
    Texts texts = Texts.of(request);
    if (fields.text("role") == null) {
      errors.add("role", texts.get("error.role"));
    }
    Role role = new InputRules(texts, errors).role("role", fields.text("role"));
    boolean disabled = fields.bool("disabled");
    fields.refuseUnknown();
    refuseIfAny(errors);
    refuseUnlessDone(
        services().accounts().change(user.id(), role, disabled, Caller.of(request).name()),
        request);
    send(request, response, user(request));
  }

  @Override
  protected void doDelete(HttpServletRequest request, HttpServletResponse response) {
    Account user = user(request);
    String by = Caller.of(request).name();
    if (!Doors.hasParameter(request, "session")) {
      refuseUnlessDone(services().accounts().delete(user.id(), by), request);
    } else if (!services().sessions().end(user, Doors.number(request, "session"), by)) {
      throw Problem.of(404, Texts.of(request).get("problem.noSuchSession")).raised();
    }
    response.setStatus(HttpServletResponse.SC_NO_CONTENT);
  }

  @Override
  protected void doPost(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Account user = user(request);
    switch (Doors.lastSegment(request)) {
      case "tokens" -> makeToken(user, request, response);
      case "reset-link" -> makeLink(user, request, response);
      case "email" -> changeEmail(user, request, response);
      default -> changePassword(user, request, response);
    }
  }

  private void changePassword(
      Account user, HttpServletRequest request, HttpServletResponse response) throws IOException {
    FieldErrors errors = new FieldErrors();
    JsonFields fields = JsonFields.of(request, errors);
    String password = fields.text("password");
    String old = fields.text("old");
    fields.refuseUnknown();
    refuseIfAny(errors);
    new UserWishes(services(), Texts.of(request), errors)
        .changePassword(Caller.of(request), user, password, old);
    refuseIfAny(errors);
    response.setStatus(HttpServletResponse.SC_NO_CONTENT);
  }

  private void changeEmail(Account user, HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    FieldErrors errors = new FieldErrors();
    JsonFields fields = JsonFields.of(request, errors);
    String email = fields.text("email");
    String password = fields.text("password");
    fields.refuseUnknown();
    refuseIfAny(errors);
    new UserWishes(services(), Texts.of(request), errors)
        .changeEmail(Caller.of(request), user, email, "password", password);
    refuseIfAny(errors);
    response.setStatus(HttpServletResponse.SC_NO_CONTENT);
  }

  private void makeToken(Account user, HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Texts texts = Texts.of(request);
    if (!UserWishes.isOwn(Caller.of(request), user)) {
      throw Problem.of(403, texts.get("problem.notYourToken")).raised();
    }
    FieldErrors errors = new FieldErrors();
    JsonFields fields = JsonFields.of(request, errors);
    String name = fields.text("name");
    Double days = fields.number("days");
    fields.refuseUnknown();
    refuseIfAny(errors);
    Optional<Sessions.Begun> made =
        new UserWishes(services(), texts, errors)
            .makeToken(Caller.of(request), user, "name", name, days, request);
    refuseIfAny(errors);
    Sessions.Begun begun = made.orElseThrow();
    Json.send(
        request,
        response,
        HttpServletResponse.SC_CREATED,
        new TokenJson(begun.secret(), SessionJson.of(begun.session())));
  }

  /**
   * @param token told but once
   */
  private record TokenJson(String token, SessionJson session) {}

  private void makeLink(Account user, HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    String link =
        services().passwordLinks().byHand(user, Doors.site(request), Caller.of(request).name());
    Json.send(request, response, HttpServletResponse.SC_CREATED, Map.of("link", link));
  }

  /** Of others a clerk knows nothing. */
  private Account user(HttpServletRequest request) {
    Caller caller = Caller.of(request);
    return services()
        .accounts()
        .byId(Doors.number(request, "id"))
        .filter(user -> UserWishes.maySee(caller, user))
        .orElseThrow(() -> Problem.of(404, Texts.of(request).get("problem.noSuchUser")).raised());
  }

  private void refuseUnlessDone(Accounts.Outcome outcome, HttpServletRequest request) {
    new UserWishes(services(), Texts.of(request), new FieldErrors())
        .refusal(outcome)
        .ifPresent(
            sentence -> {
              throw Problem.of(409, sentence).raised();
            });
  }
}
