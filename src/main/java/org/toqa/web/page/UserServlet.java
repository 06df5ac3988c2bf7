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
import org.toqa.web.Texts;
import org.toqa.web.UserWishes;
import org.toqa.web.access.Caller;
import org.toqa.web.access.Sessions;

/** One user: what he may do, a new password, and the end. */
public final class UserServlet extends PageServlet {
  @Override
  protected void doPost(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<Account> user = services().accounts().byId(Doors.number(request, "id"));
    if (user.isEmpty()) {
      notFound(request, response, "problem.noSuchUser");
      return;
    }
    String by = Caller.of(request).name();
    switch (Doors.lastSegment(request)) {
      case "delete" ->
          end(
              services().accounts().delete(user.get().id(), by),
              "deleted",
              user.get(),
              request,
              response);
      case "change" -> change(user.get(), by, request, response);
      default -> changePassword(user.get(), request, response);
    }
  }

  private void change(
      Account user, String by, HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    FieldErrors errors = new FieldErrors();
    FormFields fields = new FormFields(request, errors);
    Role role = new InputRules(Texts.of(request), errors).role("role", fields.text("role"));
    if (!errors.isEmpty()) {
      showUsersAgain(request, response, errors);
      return;
    }
    boolean disabled = fields.text("disabled") != null;
    end(
        services().accounts().change(user.id(), role, disabled, by),
        "changed",
        user,
        request,
        response);
  }

  private void end(
      Accounts.Outcome outcome,
      String done,
      Account user,
      HttpServletRequest request,
      HttpServletResponse response)
      throws ServletException, IOException {
    FieldErrors errors = new FieldErrors();
    new UserWishes(services(), Texts.of(request), errors)
        .refusal(outcome)
        .ifPresent(sentence -> errors.add(field(user), sentence));
    if (errors.isEmpty()) {
      goTo(request, response, "/users?done=" + done);
    } else {
      showUsersAgain(request, response, errors);
    }
  }

  /** A user changes his own with the old one; a manager changes others'. */
  private void changePassword(
      Account user, HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Caller caller = Caller.of(request);
    Texts texts = Texts.of(request);
    if (!UserWishes.mayChangePassword(caller, user)) {
      ErrorServlet.send(request, response, 403, texts.get("problem.managersOnly"));
      return;
    }
    FieldErrors errors = new FieldErrors();
    FormFields fields = new FormFields(request, errors);
    new UserWishes(services(), texts, errors)
        .changePassword(caller, user, field(user), fields.text("password"), fields.text("old"));
    if (!errors.isEmpty()) {
      showUsersAgain(request, response, errors);
      return;
    }
    if (UserWishes.isOwn(caller, user)) {
      Sessions.begin(request, services().accounts().byId(user.id()).orElseThrow());
    }
    goTo(request, response, "/users?done=password");
  }

  /** Under which the user's errors are shown. */
  private static String field(Account user) {
    return "user" + user.id();
  }

  private void showUsersAgain(
      HttpServletRequest request, HttpServletResponse response, FieldErrors errors)
      throws ServletException, IOException {
    UsersServlet.offerUsers(request, services());
    showAgain(request, response, "users", errors);
  }
}
