package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Optional;
import org.toqa.store.Account;
import org.toqa.web.Doors;
import org.toqa.web.FieldErrors;
import org.toqa.web.InputRules;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.access.Sessions;

/** One user: a new password, and the end. */
public final class UserServlet extends PageServlet {
  @Override
  protected void doPost(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<Account> user = services().accounts().byId(pathNumber(request, "id"));
    if (user.isEmpty()) {
      notFound(request, response, "problem.noSuchUser");
    } else if (Doors.lastSegment(request).equals("delete")) {
      delete(user.get(), request, response);
    } else {
      changePassword(user.get(), request, response);
    }
  }

  private void delete(Account user, HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    switch (services().accounts().delete(user.id())) {
      case DELETED, UNKNOWN -> goTo(request, response, "/users?done=deleted");
      case LAST_MANAGER -> {
        FieldErrors errors = new FieldErrors();
        errors.add("user" + user.id(), Texts.of(request).get("error.lastManager"));
        showUsersAgain(request, response, errors);
      }
    }
  }

  /** A user changes his own with the old one; a manager changes others'. */
  private void changePassword(
      Account user, HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Caller caller = Caller.of(request);
    boolean own = caller.account().id() == user.id();
    Texts texts = Texts.of(request);
    if (!own && !caller.isManager()) {
      ErrorServlet.send(request, response, 403, texts.get("problem.managersOnly"));
      return;
    }
    FieldErrors errors = new FieldErrors();
    FormFields fields = new FormFields(request, errors);
    String field = "user" + user.id();
    String password =
        new InputRules(texts, errors).newPassword(field, fields.text("password"), user.name());
    if (own && !services().passwords().matches(old(fields), Optional.of(user))) {
      errors.add(field, texts.get("error.password.old"));
    }
    if (!errors.isEmpty()) {
      showUsersAgain(request, response, errors);
      return;
    }
    services().accounts().changePassword(user.id(), services().passwords().hash(password));
    if (own) {
      Sessions.begin(request, services().accounts().byId(user.id()).orElseThrow());
    }
    goTo(request, response, "/users?done=password");
  }

  private static String old(FormFields fields) {
    String given = fields.text("old");
    return given == null ? "" : given;
  }

  private void showUsersAgain(
      HttpServletRequest request, HttpServletResponse response, FieldErrors errors)
      throws ServletException, IOException {
    UsersServlet.offerUsers(request, services());
    showAgain(request, response, "users", errors);
  }
}
