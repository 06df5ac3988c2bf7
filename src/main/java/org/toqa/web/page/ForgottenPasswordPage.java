package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.time.Duration;
import org.toqa.web.Sites;
import org.toqa.web.Texts;
import org.toqa.web.input.FieldErrors;

/** Where somebody who forgot his password asks for a link. */
public final class ForgottenPasswordPage extends PageHandler {
  public static void show(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    addAttributes(request);
    show(request, response, "forgotten");
  }

  public static void sendLink(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    FieldErrors errors = new FieldErrors();
    String user = new FormFields(request, errors).text("user");
    Texts texts = Texts.of(request);
    if (!services(request).passwordLinks().canMail()) {
      errors.add("form", texts.get("forgotten.manager"));
    } else if (user == null) {
      errors.add("user", texts.get("error.forgotten.user"));
    } else {
      Duration wait =
          Sites.of(request.getServletContext())
              .sendPasswordLink(user, request.getRemoteAddr(), texts);
      if (wait.isZero()) {
        redirect(request, response, "/forgotten?done=sent");
        return;
      }
      errors.add(
          "form", texts.get("error.login.tooManyAttempts", wait.plusMillis(999).toSeconds()));
    }
    addAttributes(request);
    showAgain(request, response, "forgotten", errors);
  }

  private static void addAttributes(HttpServletRequest request) {
    request.setAttribute("byMail", services(request).passwordLinks().canMail());
  }
}
