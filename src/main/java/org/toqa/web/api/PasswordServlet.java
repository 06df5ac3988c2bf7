package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.time.Duration;
import java.util.Objects;
import org.toqa.store.Account;
import org.toqa.web.Doors;
import org.toqa.web.FieldErrors;
import org.toqa.web.InputRules;
import org.toqa.web.Texts;

/** For who forgot his password: a link by e-mail, and the new password by the link's secret. */
public final class PasswordServlet extends ApiServlet {
  @Override
  protected void doPost(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    if (Doors.pathOf(request).endsWith("/forgotten-password")) {
      mailLink(request, response);
    } else {
      replace(request, response);
    }
  }

  private void mailLink(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Texts texts = Texts.of(request);
    FieldErrors errors = new FieldErrors();
    JsonFields fields = JsonFields.of(request, errors);
    String user = fields.text("user");
    fields.refuseUnknown();
    if (user == null) {
      errors.add("user", texts.get("error.forgotten.user"));
    }
    refuseIfAny(errors);
    if (!services().passwordLinks().areMailed()) {
      throw Problem.of(409, texts.get("forgotten.manager")).raised();
    }
    Duration wait =
        services()
            .passwordLinks()
            .mail(Objects.requireNonNull(user), request.getRemoteAddr(), texts);
    if (wait.isPositive()) {
      long seconds = wait.plusMillis(999).toSeconds();
      response.setHeader("Retry-After", Long.toString(seconds));
      throw Problem.of(429, texts.get("error.login.tooSoon", seconds)).raised();
    }
    response.setStatus(HttpServletResponse.SC_ACCEPTED);
  }

  private void replace(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Texts texts = Texts.of(request);
    FieldErrors errors = new FieldErrors();
    JsonFields fields = JsonFields.of(request, errors);
    String secret = Objects.requireNonNullElse(fields.text("secret"), "");
    String given = fields.text("password");
    fields.refuseUnknown();
    refuseIfAny(errors);
    Account user =
        services()
            .passwordLinks()
            .user(secret)
            .orElseThrow(() -> Problem.of(410, texts.get("reset.over")).raised());
    String password = new InputRules(texts, errors).newPassword("password", given, user.name());
    refuseIfAny(errors);
    if (!services().passwordLinks().replace(secret, services().passwords().hash(password))) {
      throw Problem.of(410, texts.get("reset.over")).raised();
    }
    response.setStatus(HttpServletResponse.SC_NO_CONTENT);
  }
}
