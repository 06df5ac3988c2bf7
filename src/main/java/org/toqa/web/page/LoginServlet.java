package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.toqa.web.FieldErrors;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.access.Login;
import org.toqa.web.access.SessionCookie;

/** The front door: name and password. */
public final class LoginServlet extends PageServlet {
  private static final String FIRST_PAGE = "/map";

  @Override
  protected void doGet(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    if (Caller.ifKnown(request).isPresent()) {
      goTo(request, response, FIRST_PAGE);
    } else {
      show(request, response, "login");
    }
  }

  @Override
  protected void doPost(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Texts texts = Texts.of(request);
    FieldErrors errors = new FieldErrors();
    FormFields fields = new FormFields(request, errors);
    String name = fields.text("name");
    String password = fields.text("password");
    if (name == null) {
      errors.add("name", texts.get("error.login.name"));
    }
    if (password == null) {
      errors.add("password", texts.get("error.login.password"));
    }
    if (name == null || password == null) {
      showAgain(request, response, "login", errors);
      return;
    }
    switch (services().login().attempt(name, password, request.getRemoteAddr())) {
      case Login.Outcome.Welcome welcome -> {
        SessionCookie.begin(request, response, services(), welcome.account());
        goTo(request, response, OwnPages.at(request.getParameter("next")).orElse(FIRST_PAGE));
      }
      case Login.Outcome.Wrong() -> {
        errors.add("form", texts.get("error.login.wrong"));
        showAgain(request, response, "login", errors);
      }
      case Login.Outcome.Disabled() -> {
        errors.add("form", texts.get("error.login.disabled"));
        showAgain(request, response, "login", errors);
      }
      case Login.Outcome.TooSoon tooSoon -> {
        errors.add("form", texts.get("error.login.tooSoon", tooSoon.seconds()));
        response.setHeader("Retry-After", Long.toString(tooSoon.seconds()));
        showAgain(request, response, "login", errors);
      }
    }
  }
}
