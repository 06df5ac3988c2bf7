package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.time.Duration;
import java.util.Objects;
import org.toqa.accounts.Account;
import org.toqa.web.Services;
import org.toqa.web.Sites;
import org.toqa.web.Texts;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.InputRules;
import org.toqa.web.input.JsonFields;

/** For who forgot his password: a link by e-mail, and the new password by the link's secret. */
public final class PasswordResetResource extends ApiHandler {
  public static void sendLink(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Texts texts = Texts.of(request);
    FieldErrors errors = new FieldErrors();
    JsonFields fields = JsonBody.read(request, errors);
    String user = fields.text("user");
    fields.refuseUnknown();
    if (user == null) {
      errors.add("user", texts.get("error.forgotten.user"));
    }
    throwIfAny(errors);
    if (!services(request).passwordLinks().canMail()) {
      throw Problem.of(409, texts.get("forgotten.manager")).exception();
    }
    Duration wait =
        Sites.of(request.getServletContext())
            .sendPasswordLink(Objects.requireNonNull(user), request.getRemoteAddr(), texts);
    if (wait.isPositive()) {
      long seconds = wait.plusMillis(999).toSeconds();
      response.setHeader("Retry-After", Long.toString(seconds));
      throw Problem.of(429, texts.get("error.login.tooManyAttempts", seconds)).exception();
    }
    response.setStatus(HttpServletResponse.SC_ACCEPTED);
  }

  public static void replacePassword(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Texts texts = Texts.of(request);
    FieldErrors errors = new FieldErrors();
    JsonFields fields = JsonBody.read(request, errors);
    String secret = Objects.requireNonNullElse(fields.text("secret"), "");
    String given = fields.text("password");
    fields.refuseUnknown();
    throwIfAny(errors);
    Services site = Sites.of(request.getServletContext()).ofSecret(secret);
    Account user =
        site.passwordLinks()
            .user(secret)
            .orElseThrow(() -> Problem.of(410, texts.get("reset.expired")).exception());
    String password = new InputRules(texts, errors).newPassword("password", given, user.name());
    throwIfAny(errors);
    if (!site.passwordLinks().replacePassword(secret, site.passwordHasher().hash(password))) {
      throw Problem.of(410, texts.get("reset.expired")).exception();
    }
    response.setStatus(HttpServletResponse.SC_NO_CONTENT);
  }
}
