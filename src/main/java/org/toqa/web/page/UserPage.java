package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import org.jspecify.annotations.Nullable;
import org.toqa.accounts.Account;
import org.toqa.accounts.AccountStore;
import org.toqa.accounts.Role;
import org.toqa.accounts.Scope;
import org.toqa.accounts.Session;
import org.toqa.web.ErrorResponse;
import org.toqa.web.PasswordLinks;
import org.toqa.web.RequestPath;
import org.toqa.web.Services;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.access.SessionCookie;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.InputRules;
import org.toqa.web.input.SessionQueryReader;
import org.toqa.web.input.UserCommands;
import org.toqa.web.input.UserDeletion;
import org.toqa.web.input.Version;

/** One user: his sessions and tokens, password and e-mail address, what he may do, and the end. */
public final class UserPage extends PageHandler {
  /** Names of what is shown once: for {@link ShownOnce}, and for the view. */
  private static final String TOKEN = "token";

  private static final String LINK = "link";

  /** Sessions. */
  private static final int PAGE_SIZE = 20;

  /** A session as the page shows it. */
  public record Line(Session session, AgentName agent) {}

  public static void show(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<Account> user = user(request, response);
    if (user.isEmpty()) {
      return;
    }
    addAttributes(user.get(), request, services(request));
    for (String secret : new String[] {TOKEN, LINK}) {
      ShownOnce.of(request.getServletContext())
          .take(Caller.of(request), secret + user.get().id())
          .ifPresent(shown -> request.setAttribute(secret, shown));
    }
    request.setAttribute("linkHours", PasswordLinks.createdLinkLifetime().toHours());
    show(request, response, "user");
  }

  public static void change(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    submit(request, response, UserPage::compareChange, UserPage::saveChange);
  }

  public static void changeEmail(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    submit(request, response, UserPage::compareEmail, UserPage::saveEmail);
  }

  public static void changePassword(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    submit(request, response, UserPage::savePassword);
  }

  public static void createToken(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    submit(request, response, UserPage::issueToken);
  }

  public static void createLink(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    submit(request, response, UserPage::issueLink);
  }

  public static void endSession(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    submit(request, response, UserPage::end);
  }

  public static void delete(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    submit(request, response, UserPage::remove);
  }

  /** Does what a form of the page asks. */
  @FunctionalInterface
  private interface Submission {
    /**
     * @return where the browser goes next
     */
    String run(Form form);
  }

  /** A form of the page that was sent. */
  private record Form(
      Account user, HttpServletRequest request, HttpServletResponse response, FieldErrors errors) {
    UserCommands commands() {
      return UserCommands.of(request, errors);
    }

    FormFields fields() {
      return new FormFields(request, errors);
    }

    Caller caller() {
      return Caller.of(request);
    }

    /** What the entries were compared with; null where the form does not say its version. */
    @Nullable Account seen() {
      return request.getParameter("version") == null ? null : user;
    }
  }

  private static void submit(
      HttpServletRequest request, HttpServletResponse response, Submission submission)
      throws ServletException, IOException {
    submit(request, response, (user, conflict) -> {}, submission);
  }

  /**
   * @param comparison of the form's entries with what is stored
   */
  private static void submit(
      HttpServletRequest request,
      HttpServletResponse response,
      BiConsumer<Account, EditConflict> comparison,
      Submission submission)
      throws ServletException, IOException {
    Optional<Account> found = user(request, response);
    if (found.isEmpty()) {
      return;
    }
    Account user = found.get();
    if (!UserCommands.canChange(Caller.of(request), user)) {
      ErrorResponse.sendText(request, response, 403, "problem.administratorsOnly");
      return;
    }
    EditConflict conflict = new EditConflict(request, Version.of(user));
    comparison.accept(user, conflict);
    FieldErrors differences = conflict.differences();
    if (!differences.isEmpty()) {
      addAttributes(user, request, services(request));
      showConflict(request, response, "user", differences);
      return;
    }
    FieldErrors errors = new FieldErrors();
    String next = submission.run(new Form(user, request, response, errors));
    if (!errors.isEmpty()) {
      addAttributes(user, request, services(request));
      showAgain(request, response, "user", errors);
    } else {
      redirect(request, response, next);
    }
  }

  /** The user in the path; empty when the answer is given: there is none, or he is not seen. */
  private static Optional<Account> user(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Optional<Account> user =
        services(request).accounts().account(RequestPath.number(request, "id"));
    if (user.isEmpty()) {
      sendNotFound(request, response, "problem.noSuchUser");
    } else if (!UserCommands.canSee(Caller.of(request), user.get())) {
      ErrorResponse.send(request, response, 403, Texts.of(request).get("problem.managersOnly"));
      return Optional.empty();
    }
    return user;
  }

  /** For the view "user". */
  static void addAttributes(Account user, HttpServletRequest request, Services services) {
    Account now = services.accounts().account(user.id()).orElse(user);
    request.setAttribute("user", now);
    request.setAttribute("version", Version.of(now));
    request.setAttribute("scopes", Scope.values());
    SessionQueryReader query = new SessionQueryReader(request);
    List<Session> sessions = query.filter(services.sessions().sessions(user.id()));
    request.setAttribute("isFiltered", query.isFiltered());
    request.setAttribute("kinds", Session.Kind.values());
    request.setAttribute("sessionCount", sessions.size());
    request.setAttribute(
        "sessions",
        ListPage.of(request, sessions.size(), PAGE_SIZE).of(sessions).stream()
            .map(session -> new Line(session, AgentName.of(session.origin().agent())))
            .toList());
    if (Caller.of(request).isManager()) {
      UserDeletion deletion = new UserDeletion(services, Texts.of(request), new FieldErrors(), now);
      request.setAttribute("belongings", deletion.belongings());
      request.setAttribute(
          "heirs", services.accounts().accounts().stream().filter(deletion::mayInherit).toList());
    }
  }

  private static void compareChange(Account user, EditConflict conflict) {
    String role = user.role().name();
    conflict
        .compareEntry("role", role, conflict.text("users.role." + role))
        .compareFlag(
            "disabled",
            user.disabled(),
            conflict.text(user.disabled() ? "users.disabled" : "users.enabled"));
  }

  private static void compareEmail(Account user, EditConflict conflict) {
    conflict.compareText("email", user.email(), conflict.text("common.none"));
  }

  private static String remove(Form form) {
    FormFields fields = form.fields();
    new UserDeletion(services(form.request()), Texts.of(form.request()), form.errors(), form.user())
        .run(
            form.caller(),
            new UserDeletion.Choices(
                fields.text("tasks"),
                fields.text("load"),
                fields.text("schedules"),
                fields.text("tokens"),
                fields.text("to")));
    return "/users?done=deleted";
  }

  private static String saveChange(Form form) {
    FormFields fields = form.fields();
    Role role =
        new InputRules(Texts.of(form.request()), form.errors())
            .role("role", fields.text("role"), form.caller());
    boolean disabled = fields.text("disabled") != null;
    if (form.errors().isEmpty()) {
      refuseUnlessDone(
          services(form.request())
              .accounts()
              .update(form.user().id(), role, disabled, form.seen(), form.caller().name()),
          form);
    }
    return page(form, "changed");
  }

  private static void refuseUnlessDone(AccountStore.ChangeResult outcome, Form form) {
    UserCommands.refusal(outcome, Texts.of(form.request()))
        .ifPresent(sentence -> form.errors().add("form", sentence));
  }

  /** A user changes his own with the old one; a manager changes others'. */
  private static String savePassword(Form form) {
    FormFields fields = form.fields();
    form.commands()
        .changePassword(form.caller(), form.user(), fields.text("password"), fields.text("old"));
    if (form.errors().isEmpty() && UserCommands.isSelf(form.caller(), form.user())) {
      Services services = services(form.request());
      SessionCookie.signIn(
          form.request(),
          form.response(),
          services,
          services.accounts().account(form.user().id()).orElseThrow());
    }
    return page(form, "password");
  }

  private static String saveEmail(Form form) {
    FormFields fields = form.fields();
    form.commands()
        .changeEmail(
            form.caller(),
            form.user(),
            form.seen(),
            fields.text("email"),
            "emailPassword",
            fields.text("password"));
    return page(form, "email");
  }

  private static String end(Form form) {
    HttpServletRequest request = form.request();
    if (!services(request)
        .sessions()
        .end(form.user(), RequestPath.number(request, "session"), form.caller().name())) {
      form.errors().add("form", Texts.of(request).get("problem.noSuchSession"));
    }
    return page(form, "ended");
  }

  private static String issueToken(Form form) {
    FormFields fields = form.fields();
    form.commands()
        .createToken(
            form.caller(),
            form.user(),
            "tokenName",
            "tokenPassword",
            new UserCommands.TokenOrder(
                fields.text("tokenName"),
                fields.number("days"),
                fields.choices("scopes"),
                fields.text("password")))
        .ifPresent(created -> showOnce(form, TOKEN, created.secret()));
    return page(form, TOKEN);
  }

  private static String issueLink(Form form) {
    HttpServletRequest request = form.request();
    String link =
        services(request)
            .passwordLinks()
            .createLink(form.user(), RequestPath.baseUrl(request), form.caller().name());
    showOnce(form, LINK, link);
    return page(form, LINK);
  }

  /** On the page to which the answer leads. */
  private static void showOnce(Form form, String name, String secret) {
    ShownOnce.of(form.request().getServletContext())
        .put(form.caller(), name + form.user().id(), secret);
  }

  private static String page(Form form, String done) {
    return "/users/" + form.user().id() + "?done=" + done;
  }
}
