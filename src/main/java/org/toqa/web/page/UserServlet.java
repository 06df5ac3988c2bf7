package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Optional;
import org.toqa.accounts.Account;
import org.toqa.accounts.AccountStore;
import org.toqa.accounts.Role;
import org.toqa.web.ErrorResponse;
import org.toqa.web.PasswordLinks;
import org.toqa.web.RequestPath;
import org.toqa.web.Services;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.access.SessionCookie;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.InputRules;
import org.toqa.web.input.UserCommands;
import org.toqa.web.input.Version;

/** One user: his sessions and tokens, password and e-mail address, what he may do, and the end. */
public final class UserServlet extends PageServlet {
  @Override
  protected void doGet(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<Account> user = user(request, response);
    if (user.isEmpty()) {
      return;
    }
    addAttributes(user.get(), request, services());
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
      addAttributes(user, request, services());
      showConflict(request, response, "user", differences);
      return;
    }
    FieldErrors errors = new FieldErrors();
    UserCommands commands = new UserCommands(services(), Texts.of(request), errors);
    String next =
        switch (RequestPath.lastSegment(request)) {
          case "delete" -> delete(user, commands, errors, request);
          case "change" -> change(user, commands, errors, request);
          case "email" -> changeEmail(user, commands, errors, request);
          case "end" -> endSession(user, errors, request);
          case "tokens" -> createToken(user, commands, errors, request);
          case "reset-link" -> createLink(user, request);
          default -> changePassword(user, commands, errors, request, response);
        };
    if (!errors.isEmpty()) {
      addAttributes(user, request, services());
      showAgain(request, response, "user", errors);
    } else if (next.isEmpty()) {
      addAttributes(user, request, services());
      show(request, response, "user");
    } else {
      redirect(request, response, next);
    }
  }

  /** The user in the path; empty when the answer is given: there is none, or he is not seen. */
  private Optional<Account> user(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Optional<Account> user = services().accounts().account(RequestPath.number(request, "id"));
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
    request.setAttribute("sessions", services.sessions().sessions(user.id()));
  }

  private static FieldErrors differences(Account user, HttpServletRequest request) {
    Texts texts = Texts.of(request);
    EditConflict conflict = new EditConflict(request, Version.of(user));
    switch (RequestPath.lastSegment(request)) {
      case "change" -> {
        String role = user.role().name();
        conflict.compareEntry(
            "role", request.getParameter("role"), role, texts.get("users.role." + role));
        conflict.compareEntry(
            "disabled",
            String.valueOf(request.getParameter("disabled") != null),
            String.valueOf(user.disabled()),
            texts.get(user.disabled() ? "users.disabled" : "users.enabled"));
      }
      case "email" -> conflict.compareText("email", user.email(), texts.get("common.none"));
      default -> {}
    }
    return conflict.differences();
  }

  private String delete(
      Account user, UserCommands commands, FieldErrors errors, HttpServletRequest request) {
    refuseUnlessDone(
        services().accounts().delete(user.id(), Caller.of(request).name()), commands, errors);
    return "/users?done=deleted";
  }

  private String change(
      Account user, UserCommands commands, FieldErrors errors, HttpServletRequest request) {
    FormFields fields = new FormFields(request, errors);
    Role role = new InputRules(Texts.of(request), errors).role("role", fields.text("role"));
    boolean disabled = fields.text("disabled") != null;
    if (errors.isEmpty()) {
      refuseUnlessDone(
          services().accounts().update(user.id(), role, disabled, Caller.of(request).name()),
          commands,
          errors);
    }
    return page(user, "changed");
  }

  private static void refuseUnlessDone(
      AccountStore.ChangeResult outcome, UserCommands commands, FieldErrors errors) {
    commands.refusal(outcome).ifPresent(sentence -> errors.add("form", sentence));
  }

  /** A user changes his own with the old one; a manager changes others'. */
  private String changePassword(
      Account user,
      UserCommands commands,
      FieldErrors errors,
      HttpServletRequest request,
      HttpServletResponse response) {
    FormFields fields = new FormFields(request, errors);
    Caller caller = Caller.of(request);
    commands.changePassword(caller, user, fields.text("password"), fields.text("old"));
    if (errors.isEmpty() && UserCommands.isSelf(caller, user)) {
      SessionCookie.signIn(
          request, response, services(), services().accounts().account(user.id()).orElseThrow());
    }
    return page(user, "password");
  }

  private String changeEmail(
      Account user, UserCommands commands, FieldErrors errors, HttpServletRequest request) {
    FormFields fields = new FormFields(request, errors);
    commands.changeEmail(
        Caller.of(request), user, fields.text("email"), "emailPassword", fields.text("password"));
    return page(user, "email");
  }

  private String endSession(Account user, FieldErrors errors, HttpServletRequest request) {
    if (!services()
        .sessions()
        .end(user, RequestPath.number(request, "session"), Caller.of(request).name())) {
      errors.add("form", Texts.of(request).get("problem.noSuchSession"));
    }
    return page(user, "ended");
  }

  /** Shown once, on the page that answers. */
  private String createToken(
      Account user, UserCommands commands, FieldErrors errors, HttpServletRequest request) {
    FormFields fields = new FormFields(request, errors);
    commands
        .createToken(
            Caller.of(request),
            user,
            "tokenName",
            fields.text("tokenName"),
            fields.number("days"),
            request)
        .ifPresent(created -> request.setAttribute("token", created.secret()));
    return "";
  }

  /** Shown once, on the page that answers. */
  private String createLink(Account user, HttpServletRequest request) {
    request.setAttribute(
        "link",
        services()
            .passwordLinks()
            .createLink(user, RequestPath.baseUrl(request), Caller.of(request).name()));
    request.setAttribute("linkHours", PasswordLinks.createdLinkLifetime().toHours());
    return "";
  }

  private static String page(Account user, String done) {
    return "/users/" + user.id() + "?done=" + done;
  }
}
