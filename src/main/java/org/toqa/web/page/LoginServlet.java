package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.jspecify.annotations.Nullable;
import org.toqa.web.Doors;
import org.toqa.web.FieldErrors;
import org.toqa.web.Right;
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
        goTo(request, response, next(request.getParameter("next")));
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

  /** Where the stranger wanted to go, if that is a page of ours. */
  private static String next(@Nullable String wanted) {
    if (wanted == null) {
      return FIRST_PAGE;
    }
    return Doors.at(wanted)
        .flatMap(place -> place.door("GET"))
        .filter(door -> !door.isApi() && door.right() == Right.USER)
        .map(page -> wanted)
        .orElse(FIRST_PAGE);
  }
}
