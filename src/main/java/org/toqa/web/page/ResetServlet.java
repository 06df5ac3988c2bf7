package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Objects;
import java.util.Optional;
import org.toqa.store.Account;
import org.toqa.web.FieldErrors;
import org.toqa.web.InputRules;
import org.toqa.web.Texts;
import org.toqa.web.access.SessionCookie;

/** Where a link leads by which a forgotten password is replaced. */
public final class ResetServlet extends PageServlet {
  private static final int GONE = 410;

  @Override
  protected void doGet(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<Account> user = services().passwordLinks().user(secret(request));
    if (user.isEmpty()) {
      response.setStatus(GONE);
    }
    showFor(user, request, response);
  }

  @Override
  protected void doPost(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<Account> user = services().passwordLinks().user(secret(request));
    if (user.isEmpty()) {
      response.setStatus(GONE);
      showFor(user, request, response);
      return;
    }
    FieldErrors errors = new FieldErrors();
    String password =
        new InputRules(Texts.of(request), errors)
            .newPassword(
                "password", new FormFields(request, errors).text("password"), user.get().name());
    if (!errors.isEmpty()) {
      request.setAttribute("user", user.get());
      showAgain(request, response, "reset", errors);
      return;
    }
    if (services()
        .passwordLinks()
        .replace(secret(request), services().passwords().hash(password))) {
      SessionCookie.end(request, services());
      goTo(request, response, "/?done=reset");
    } else {
      response.setStatus(GONE);
      showFor(Optional.empty(), request, response);
    }
  }

  private static void showFor(
      Optional<Account> user, HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    user.ifPresent(account -> request.setAttribute("user", account));
    show(request, response, "reset");
  }

  private static String secret(HttpServletRequest request) {
    return Objects.requireNonNullElse(request.getParameter("secret"), "");
  }
}
