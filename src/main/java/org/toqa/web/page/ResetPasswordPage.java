package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Optional;
import org.toqa.accounts.Account;
import org.toqa.web.Services;
import org.toqa.web.Sites;
import org.toqa.web.Texts;
import org.toqa.web.access.ResetCookie;
import org.toqa.web.access.SessionCookie;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.InputRules;

/**
 * Where a link leads by which a forgotten password is replaced. Its secret is taken out of the
 * address at once ({@link ResetCookie}).
 */
public final class ResetPasswordPage extends PageHandler {
  private static final int GONE = 410;

  public static void show(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    String given = request.getParameter("secret");
    if (given != null) {
      ResetCookie.set(request, response, given);
      redirect(request, response, "/reset");
      return;
    }
    Optional<Account> user = site(request).passwordLinks().user(secret(request));
    if (user.isEmpty()) {
      response.setStatus(GONE);
    }
    showForm(user, request, response);
  }

  public static void replacePassword(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<Account> user = site(request).passwordLinks().user(secret(request));
    if (user.isEmpty()) {
      response.setStatus(GONE);
      showForm(user, request, response);
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
    if (site(request)
        .passwordLinks()
        .replacePassword(secret(request), site(request).passwordHasher().hash(password))) {
      SessionCookie.signOut(request);
      ResetCookie.remove(request, response);
      redirect(request, response, "/?done=reset");
    } else {
      response.setStatus(GONE);
      showForm(Optional.empty(), request, response);
    }
  }

  private static void showForm(
      Optional<Account> user, HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    user.ifPresent(account -> request.setAttribute("user", account));
    show(request, response, "reset");
  }

  /** Of the site whose user the link is for. */
  private static Services site(HttpServletRequest request) {
    return Sites.of(request.getServletContext()).ofSecret(secret(request));
  }

  private static String secret(HttpServletRequest request) {
    return ResetCookie.of(request).orElse("");
  }
}
