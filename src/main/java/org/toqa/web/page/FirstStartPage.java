package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Optional;
import org.toqa.accounts.Account;
import org.toqa.web.Texts;
import org.toqa.web.access.SessionCookie;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.InputRules;

/** Makes the first manager, once, for who has the code that the server printed. */
public final class FirstStartPage extends PageHandler {
  public static void show(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    if (services(request).accounts().hasManager()) {
      redirect(request, response, "/");
    } else {
      show(request, response, "first-start");
    }
  }

  public static void createManager(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    if (services(request).accounts().hasManager()) {
      redirect(request, response, "/");
      return;
    }
    FieldErrors errors = new FieldErrors();
    FormFields fields = new FormFields(request, errors);
    String code = fields.text("code");
    if (code == null || !services(request).firstStartCode().isSame(code)) {
      errors.add("code", Texts.of(request).get("error.firstStart.code"));
    }
    InputRules rules = new InputRules(Texts.of(request), errors);
    String name = rules.userName("name", fields.text("name"));
    String password = rules.newPassword("password", fields.text("password"), name);
    if (!password.equals(fields.text("repeat"))) { // nobody else could give him another one
      errors.add("repeat", Texts.of(request).get("error.firstStart.repeat"));
    }
    if (!errors.isEmpty()) {
      showAgain(request, response, "first-start", errors);
      return;
    }
    Optional<Account> manager =
        services(request)
            .accounts()
            .addFirstManager(name, services(request).passwordHasher().hash(password));
    if (manager.isEmpty()) {
      errors.add("name", Texts.of(request).get("error.userName.taken"));
      showAgain(request, response, "first-start", errors);
      return;
    }
    SessionCookie.signIn(request, response, services(request), manager.get());
    redirect(request, response, "/map");
  }
}
