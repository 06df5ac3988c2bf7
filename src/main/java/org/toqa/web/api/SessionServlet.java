package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Map;
import org.toqa.store.Session;
import org.toqa.web.FieldErrors;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.access.Login;
import org.toqa.web.access.Origins;

/** A name and a password for a bearer token, and its end. */
public final class SessionServlet extends ApiServlet {
  @Override
  protected void doPost(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Texts texts = Texts.of(request);
    FieldErrors errors = new FieldErrors();
    JsonFields fields = JsonFields.of(request, errors);
    String name = fields.text("name");
    String password = fields.text("password");
    fields.refuseUnknown();
    if (name == null) {
      errors.add("name", texts.get("error.login.name"));
    }
    if (password == null) {
      errors.add("password", texts.get("error.login.password"));
    }
    refuseIfAny(errors);
    if (name != null && password != null) {
      answer(
          services().login().attempt(name, password, request.getRemoteAddr()), request, response);
    }
  }

  /** Logs out. */
  @Override
  protected void doDelete(HttpServletRequest request, HttpServletResponse response) {
    services().sessions().end(Caller.of(request).credential().secret());
    response.setStatus(HttpServletResponse.SC_NO_CONTENT);
  }

  private void answer(
      Login.Outcome outcome, HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Texts texts = Texts.of(request);
    switch (outcome) {
      case Login.Outcome.Welcome welcome ->
          Json.send(
              request,
              response,
              200,
              Map.of(
                  "token",
                  services()
                      .sessions()
                      .begin(welcome.account(), Session.Kind.TOKEN, Origins.of(request))
                      .secret()));
      case Login.Outcome.Wrong() -> {
        response.setHeader("WWW-Authenticate", "Bearer");
        Problem.of(401, texts.get("error.login.wrong")).send(request, response);
      }
      case Login.Outcome.Disabled() ->
          Problem.of(403, texts.get("error.login.disabled")).send(request, response);
      case Login.Outcome.TooSoon tooSoon -> {
        response.setHeader("Retry-After", Long.toString(tooSoon.seconds()));
        Problem.of(429, texts.get("error.login.tooSoon", tooSoon.seconds()))
            .send(request, response);
      }
    }
  }
}
