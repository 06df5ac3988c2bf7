package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Optional;
import org.toqa.store.Account;
import org.toqa.web.FieldErrors;
import org.toqa.web.InputRules;
import org.toqa.web.Texts;
import org.toqa.web.access.SessionCookie;

/** Makes the first manager, once. */
public final class FirstStartServlet extends PageServlet {
  @Override
  protected void doGet(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    if (services().accounts().hasManager()) {
      goTo(request, response, "/");
    } else {
      show(request, response, "first-start");
    }
  }

  @Override
  protected void doPost(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    if (services().accounts().hasManager()) {
      goTo(request, response, "/");
      return;
    }
    FieldErrors errors = new FieldErrors();
    FormFields fields = new FormFields(request, errors);
    InputRules rules = new InputRules(Texts.of(request), errors);
    String name = rules.userName("name", fields.text("name"));
    String password = rules.newPassword("password", fields.text("password"), name);
    if (!errors.isEmpty()) {
      showAgain(request, response, "first-start", errors);
      return;
    }
    Optional<Account> manager =
        services().accounts().addFirstManager(name, services().passwords().hash(password));
    if (manager.isEmpty()) {
      errors.add("name", Texts.of(request).get("error.userName.taken"));
      showAgain(request, response, "first-start", errors);
      return;
    }
    SessionCookie.begin(request, response, services(), manager.get());
    goTo(request, response, "/map");
  }
}
