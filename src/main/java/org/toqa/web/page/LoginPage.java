package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.toqa.accounts.Authenticator;
import org.toqa.web.Sites;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.access.SessionCookie;
import org.toqa.web.access.VisitedSite;
import org.toqa.web.input.FieldErrors;

/** Signs in with a name and a password. */
public final class LoginPage extends PageHandler {
  private static final String FIRST_PAGE = "/map";

  public static void show(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    if (Caller.find(request).isPresent()) {
      redirect(request, response, FIRST_PAGE);
    } else {
      show(request, response, "index");
    }
  }

  public static void signIn(HttpServletRequest request, HttpServletResponse response)
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
      showAgain(request, response, "index", errors);
      return;
    }
    Sites.Login who = Sites.of(request.getServletContext()).login(name);
    switch (who.site()
        .authenticator()
        .authenticate(who.name(), password, request.getRemoteAddr())) {
      case Authenticator.Outcome.Authenticated login -> {
        SessionCookie.signIn(request, response, who.site(), login.account());
        VisitedSite.forget(request, response);
        redirect(
            request,
            response,
            ReturnAddress.parse(request, request.getParameter("next")).orElse(FIRST_PAGE));
      }
      case Authenticator.Outcome.WrongCredentials() -> {
        errors.add("form", texts.get("error.login.wrong"));
        showAgain(request, response, "index", errors);
      }
      case Authenticator.Outcome.AccountDisabled() -> {
        errors.add("form", texts.get("error.login.disabled"));
        showAgain(request, response, "index", errors);
      }
      case Authenticator.Outcome.Throttled throttled -> {
        errors.add("form", texts.get("error.login.tooManyAttempts", throttled.retryAfterSeconds()));
        response.setHeader("Retry-After", Long.toString(throttled.retryAfterSeconds()));
        showAgain(request, response, "index", errors);
      }
    }
  }
}
