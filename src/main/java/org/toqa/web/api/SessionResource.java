package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Map;
import org.toqa.accounts.Authenticator;
import org.toqa.accounts.Session;
import org.toqa.web.Services;
import org.toqa.web.Sites;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.access.RequestOrigin;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.JsonFields;

/** A name and a password for a bearer token, and its end. */
public final class SessionResource extends ApiHandler {
  public static void begin(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Texts texts = Texts.of(request);
    FieldErrors errors = new FieldErrors();
    JsonFields fields = JsonBody.read(request, errors);
    String name = fields.text("name");
    String password = fields.text("password");
    fields.refuseUnknown();
    if (name == null) {
      errors.add("name", texts.get("error.login.name"));
    }
    if (password == null) {
      errors.add("password", texts.get("error.login.password"));
    }
    throwIfAny(errors);
    if (name != null && password != null) {
      Sites.Login who = Sites.of(request.getServletContext()).login(name);
      send(
          who.site().authenticator().authenticate(who.name(), password, request.getRemoteAddr()),
          who.site(),
          request,
          response);
    }
  }

  /** Logs out. */
  public static void end(HttpServletRequest request, HttpServletResponse response) {
    services(request).sessions().end(Caller.of(request).credential().secret());
    response.setStatus(HttpServletResponse.SC_NO_CONTENT);
  }

  private static void send(
      Authenticator.Outcome outcome,
      Services site,
      HttpServletRequest request,
      HttpServletResponse response)
      throws IOException {
    Texts texts = Texts.of(request);
    switch (outcome) {
      case Authenticator.Outcome.Authenticated login ->
          Json.send(
              request,
              response,
              200,
              Map.of(
                  "token",
                  site.sessions()
                      .begin(login.account(), Session.Kind.API, RequestOrigin.of(request))
                      .secret()));
      case Authenticator.Outcome.WrongCredentials() -> {
        response.setHeader("WWW-Authenticate", "Bearer");
        Problem.of(401, texts.get("error.login.wrong")).send(request, response);
      }
      case Authenticator.Outcome.AccountDisabled() ->
          Problem.of(403, texts.get("error.login.disabled")).send(request, response);
      case Authenticator.Outcome.Throttled throttled -> {
        response.setHeader("Retry-After", Long.toString(throttled.retryAfterSeconds()));
        Problem.of(429, texts.get("error.login.tooManyAttempts", throttled.retryAfterSeconds()))
            .send(request, response);
      }
    }
  }
}
