package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.List;
import org.toqa.accounts.Account;
import org.toqa.accounts.Role;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.InputRules;
import org.toqa.web.input.UserQueryReader;

/** The users: a manager sees all and adds some, a clerk sees himself. */
public final class UsersPage extends PageHandler {
  private static final int PAGE_SIZE = 50;

  public static void show(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Caller caller = Caller.of(request);
    if (caller.isManager()) {
      FieldErrors errors = new FieldErrors();
      UserQueryReader query = new UserQueryReader(request, errors);
      addAttributes(request, query.filter(services(request).accounts().accounts()));
      request.setAttribute("isFiltered", query.isFiltered());
      showList(request, response, "users", errors);
    } else {
      UserPage.addAttributes(caller.account(), request, services(request));
      show(request, response, "user");
    }
  }

  public static void add(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    FieldErrors errors = new FieldErrors();
    FormFields fields = new FormFields(request, errors);
    Texts texts = Texts.of(request);
    InputRules rules = new InputRules(texts, errors);
    String name = rules.userName("name", fields.text("name"));
    String password = rules.newPassword("password", fields.text("password"), name);
    String email = rules.email("email", fields.text("email"));
    Role role = rules.role("role", fields.text("role"), Caller.of(request));
    if (errors.isEmpty()) {
      String hash = services(request).passwordHasher().hash(password);
      if (services(request)
          .accounts()
          .add(name, email, hash, role, Caller.of(request).name())
          .isPresent()) {
        redirect(request, response, "/users?done=added");
        return;
      }
      errors.add("name", texts.get("error.userName.taken"));
    }
    addAttributes(request, services(request).accounts().accounts());
    showAgain(request, response, "users", errors);
  }

  private static void addAttributes(HttpServletRequest request, List<Account> wanted) {
    request.setAttribute("count", wanted.size());
    request.setAttribute("roles", Role.values());
    request.setAttribute("users", ListPage.of(request, wanted.size(), PAGE_SIZE).of(wanted));
  }
}
