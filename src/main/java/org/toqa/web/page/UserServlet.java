package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Optional;
import org.toqa.store.Account;
import org.toqa.store.Accounts;
import org.toqa.store.Role;
import org.toqa.web.Doors;
import org.toqa.web.FieldErrors;
import org.toqa.web.InputRules;
import org.toqa.web.Services;
import org.toqa.web.Texts;
import org.toqa.web.UserWishes;
import org.toqa.web.Version;
import org.toqa.web.access.Caller;
import org.toqa.web.access.PasswordLinks;
import org.toqa.web.access.SessionCookie;

/** One user: his sessions and tokens, password and e-mail address, what he may do, and the end. */
public final class UserServlet extends PageServlet {
  @Override
  protected void doGet(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<Account> user = user(request, response);
    if (user.isEmpty()) {
      return;
    }
    offer(user.get(), request, services());
    show(request, response, "user");
  }

  @Override
  protected void doPost(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<Account> found = user(request, response);
    if (found.isEmpty()) {
      return;
    }
    Account user = found.get();
    FieldErrors differences = differences(user, request);
    if (!differences.isEmpty()) {
      offer(user, request, services());
      showConflict(request, response, "user", differences);
      return;
    }
    FieldErrors errors = new FieldErrors();
    UserWishes wishes = new UserWishes(services(), Texts.of(request), errors);
    String next =
        switch (Doors.lastSegment(request)) {
          case "delete" -> delete(user, wishes, errors, request);
          case "change" -> change(user, wishes, errors, request);
          case "email" -> changeEmail(user, wishes, errors, request);
          case "end" -> endSession(user, errors, request);
          case "tokens" -> makeToken(user, wishes, errors, request);
          case "reset-link" -> makeLink(user, request);
          default -> changePassword(user, wishes, errors, request, response);
        };
    if (!errors.isEmpty()) {
      offer(user, request, services());
      showAgain(request, response, "user", errors);
    } else if (next.isEmpty()) {
      offer(user, request, services());
      show(request, response, "user");
    } else {
      goTo(request, response, next);
    }
  }

  /** The user in the path; empty when the answer is given: there is none, or he is not seen. */
  private Optional<Account> user(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Optional<Account> user = services().accounts().byId(Doors.number(request, "id"));
    if (user.isEmpty()) {
      notFound(request, response, "problem.noSuchUser");
    } else if (!UserWishes.maySee(Caller.of(request), user.get())) {
      ErrorServlet.send(request, response, 403, Texts.of(request).get("problem.managersOnly"));
      return Optional.empty();
    }
    return user;
  }

  /** For the view "user". */
  static void offer(Account user, HttpServletRequest request, Services services) {
    Account now = services.accounts().byId(user.id()).orElse(user);
    request.setAttribute("user", now);
    request.setAttribute("version", Version.of(now));
    request.setAttribute("sessions", services.sessions().of(user.id()));
  }

  private static FieldErrors differences(Account user, HttpServletRequest request) {
    Texts texts = Texts.of(request);
    Rivals rivals = new Rivals(request, Version.of(user));
    switch (Doors.lastSegment(request)) {
      case "change" -> {
        String role = user.role().name();
        rivals.entry("role", request.getParameter("role"), role, texts.get("users.role." + role));
        rivals.entry(
            "disabled",
            String.valueOf(request.getParameter("disabled") != null),
            String.valueOf(user.disabled()),
            texts.get(user.disabled() ? "users.disabled" : "users.enabled"));
      }
      case "email" -> rivals.text("email", user.email(), texts.get("common.none"));
      default -> {}
    }
    return rivals.differences();
  }

  private String delete(
      Account user, UserWishes wishes, FieldErrors errors, HttpServletRequest request) {
    refuseUnlessDone(
        services().accounts().delete(user.id(), Caller.of(request).name()), wishes, errors);
    return "/users?done=deleted";
  }

  private String change(
      Account user, UserWishes wishes, FieldErrors errors, HttpServletRequest request) {
    FormFields fields = new FormFields(request, errors);
    Role role = new InputRules(Texts.of(request), errors).role("role", fields.text("role"));
    boolean disabled = fields.text("disabled") != null;
    if (errors.isEmpty()) {
      refuseUnlessDone(
          services().accounts().change(user.id(), role, disabled, Caller.of(request).name()),
          wishes,
          errors);
    }
    return page(user, "changed");
  }

  private static void refuseUnlessDone(
      Accounts.Outcome outcome, UserWishes wishes, FieldErrors errors) {
    wishes.refusal(outcome).ifPresent(sentence -> errors.add("form", sentence));
  }

  /** A user changes his own with the old one; a manager changes others'. */
  private String changePassword(
      Account user,
      UserWishes wishes,
      FieldErrors errors,
      HttpServletRequest request,
      HttpServletResponse response) {
    FormFields fields = new FormFields(request, errors);
    Caller caller = Caller.of(request);
    wishes.changePassword(caller, user, fields.text("password"), fields.text("old"));
    if (errors.isEmpty() && UserWishes.isOwn(caller, user)) {
      SessionCookie.begin(
          request, response, services(), services().accounts().byId(user.id()).orElseThrow());
    }
    return page(user, "password");
  }

  private String changeEmail(
      Account user, UserWishes wishes, FieldErrors errors, HttpServletRequest request) {
    FormFields fields = new FormFields(request, errors);
    wishes.changeEmail(
        Caller.of(request), user, fields.text("email"), "emailPassword", fields.text("password"));
    return page(user, "email");
  }

  private String endSession(Account user, FieldErrors errors, HttpServletRequest request) {
    if (!services()
        .sessions()
        .end(user, Doors.number(request, "session"), Caller.of(request).name())) {
      errors.add("form", Texts.of(request).get("problem.noSuchSession"));
    }
    return page(user, "ended");
  }

  /** Shown once, on the page that answers. */
  private String makeToken(
      Account user, UserWishes wishes, FieldErrors errors, HttpServletRequest request) {
    FormFields fields = new FormFields(request, errors);
    wishes
        .makeToken(
            Caller.of(request),
            user,
            "tokenName",
            fields.text("tokenName"),
            fields.number("days"),
            request)
        .ifPresent(made -> request.setAttribute("token", made.secret()));
    return "";
  }

  /** Shown once, on the page that answers. */
  private String makeLink(Account user, HttpServletRequest request) {
    request.setAttribute(
        "link",
        services().passwordLinks().byHand(user, Doors.site(request), Caller.of(request).name()));
    request.setAttribute("linkHours", PasswordLinks.lifeByHand().toHours());
    return "";
  }

  private static String page(Account user, String done) {
    return "/users/" + user.id() + "?done=" + done;
  }
}
