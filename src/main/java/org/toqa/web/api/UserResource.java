package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.toqa.accounts.Account;
import org.toqa.accounts.AccountStore;
import org.toqa.accounts.Role;
import org.toqa.accounts.SessionStore;
import org.toqa.web.RequestPath;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.InputRules;
import org.toqa.web.input.JsonFields;
import org.toqa.web.input.UserCommands;
import org.toqa.web.input.UserDeletion;
import org.toqa.web.input.Version;

/** One user: his sessions and tokens, password and e-mail address, what he may do, and the end. */
public final class UserResource extends ApiHandler {
  public static void get(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    send(request, response, user(request));
  }

  public static void sessions(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Account user = user(request);
    Json.send(
        request,
        response,
        200,
        services(request).sessions().sessions(user.id()).stream().map(SessionJson::of).toList());
  }

  private static void send(HttpServletRequest request, HttpServletResponse response, Account user)
      throws IOException {
    response.setHeader("ETag", Version.of(user).tag());
    Json.send(request, response, 200, UserJson.of(user));
  }

  public static void change(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Account user = userToChange(request);
    requireVersion(Version.of(user), request);
    FieldErrors errors = new FieldErrors();
    JsonFields fields = JsonBody.read(request, errors);
    String given = Objects.requireNonNullElse(fields.text("role"), "");
    Role role = new InputRules(Texts.of(request), errors).role("role", given, Caller.of(request));
    boolean disabled = fields.flag("disabled");
    fields.refuseUnknown();
    throwIfAny(errors);
    Account seen = request.getHeader("If-Match") == null ? null : user;
    AccountStore.ChangeResult outcome =
        services(request)
            .accounts()
            .update(user.id(), role, disabled, seen, Caller.of(request).name());
    if (outcome == AccountStore.ChangeResult.OUTDATED) {
      throw changedMeanwhile(request);
    }
    refuseUnlessDone(outcome, request);
    send(request, response, user(request));
  }

  /** What becomes of the user's tasks, schedules and tokens is in the query. */
  public static void delete(HttpServletRequest request, HttpServletResponse response) {
    FieldErrors errors = new FieldErrors();
    new UserDeletion(services(request), Texts.of(request), errors, userToChange(request))
        .run(
            Caller.of(request),
            new UserDeletion.Choices(
                request.getParameter("tasks"),
                request.getParameter("load"),
                request.getParameter("schedules"),
                request.getParameter("tokens"),
                request.getParameter("to")));
    String refusal = errors.sentences().get("form");
    if (refusal != null) {
      throw Problem.of(409, refusal).exception();
    }
    throwIfAny(errors);
    response.setStatus(HttpServletResponse.SC_NO_CONTENT);
  }

  public static void endSession(HttpServletRequest request, HttpServletResponse response) {
    if (!services(request)
        .sessions()
        .end(
            userToChange(request),
            RequestPath.number(request, "session"),
            Caller.of(request).name())) {
      throw Problem.of(404, Texts.of(request).get("problem.noSuchSession")).exception();
    }
    response.setStatus(HttpServletResponse.SC_NO_CONTENT);
  }

  public static void changePassword(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Account user = userToChange(request);
    FieldErrors errors = new FieldErrors();
    JsonFields fields = JsonBody.read(request, errors);
    String password = fields.text("password");
    String old = fields.text("old");
    fields.refuseUnknown();
    throwIfAny(errors);
    UserCommands.of(request, errors).changePassword(Caller.of(request), user, password, old);
    throwIfAny(errors);
    response.setStatus(HttpServletResponse.SC_NO_CONTENT);
  }

  public static void changeEmail(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Account user = userToChange(request);
    FieldErrors errors = new FieldErrors();
    JsonFields fields = JsonBody.read(request, errors);
    String email = fields.text("email");
    String password = fields.text("password");
    fields.refuseUnknown();
    throwIfAny(errors);
    UserCommands.of(request, errors)
        .changeEmail(Caller.of(request), user, null, email, "password", password);
    throwIfAny(errors);
    response.setStatus(HttpServletResponse.SC_NO_CONTENT);
  }

  public static void createToken(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Account user = user(request);
    Texts texts = Texts.of(request);
    Caller caller = Caller.of(request);
    if (!UserCommands.isSelf(caller, user)) {
      throw Problem.of(403, texts.get("problem.notYourToken")).exception();
    }
    if (!caller.session().mayCreateTokens()) {
      throw Problem.of(403, texts.get("problem.tokenInBrowser")).exception();
    }
    FieldErrors errors = new FieldErrors();
    JsonFields fields = JsonBody.read(request, errors);
    UserCommands.TokenOrder order =
        new UserCommands.TokenOrder(
            fields.text("name"),
            fields.number("days"),
            fields.choices("scopes"),
            fields.text("password"));
    fields.refuseUnknown();
    throwIfAny(errors);
    Optional<SessionStore.NewSession> created =
        UserCommands.of(request, errors).createToken(caller, user, "name", "password", order);
    throwIfAny(errors);
    SessionStore.NewSession token = created.orElseThrow();
    Json.send(
        request,
        response,
        HttpServletResponse.SC_CREATED,
        new TokenJson(token.secret(), SessionJson.of(token.session())));
  }

  /**
   * @param token not shown again
   */
  private record TokenJson(String token, SessionJson session) {}

  public static void createLink(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Account user = userToChange(request);
    String link =
        services(request)
            .passwordLinks()
            .createLink(user, RequestPath.baseUrl(request), Caller.of(request).name());
    Json.send(request, response, HttpServletResponse.SC_CREATED, Map.of("link", link));
  }

  /** Of others a clerk knows nothing. */
  private static Account user(HttpServletRequest request) {
    Caller caller = Caller.of(request);
    return services(request)
        .accounts()
        .account(RequestPath.number(request, "id"))
        .filter(user -> UserCommands.canSee(caller, user))
        .orElseThrow(
            () -> Problem.of(404, Texts.of(request).get("problem.noSuchUser")).exception());
  }

  /** The same for who is to be changed. */
  private static Account userToChange(HttpServletRequest request) {
    Account user = user(request);
    if (!UserCommands.canChange(Caller.of(request), user)) {
      throw Problem.of(403, Texts.of(request).get("problem.administratorsOnly")).exception();
    }
    return user;
  }

  private static void refuseUnlessDone(
      AccountStore.ChangeResult outcome, HttpServletRequest request) {
    UserCommands.refusal(outcome, Texts.of(request))
        .ifPresent(
            sentence -> {
              throw Problem.of(409, sentence).exception();
            });
  }
}
