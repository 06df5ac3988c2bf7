package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.toqa.store.Account;
import org.toqa.store.Accounts;
import org.toqa.store.Role;
import org.toqa.web.Doors;
import org.toqa.web.FieldErrors;
import org.toqa.web.InputRules;
import org.toqa.web.Texts;
import org.toqa.web.UserWishes;
import org.toqa.web.access.Caller;

/** One user: what he may do, a new password, and the end. */
public final class UserServlet extends ApiServlet {
  @Override
  protected void doPut(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Account user = user(request);
    FieldErrors errors = new FieldErrors();
    JsonFields fields = JsonFields.of(request, errors);
    Texts texts = Texts.of(request);
    if (fields.text("role") == null) {
      errors.add("role", texts.get("error.role"));
    }
    Role role = new InputRules(texts, errors).role("role", fields.text("role"));
    boolean disabled = fields.bool("disabled");
    fields.refuseUnknown();
    refuseIfAny(errors);
    refuseUnlessDone(
        services().accounts().change(user.id(), role, disabled, Caller.of(request).name()),
        request);
    Json.send(response, 200, UserJson.of(user(request)));
  }

  @Override
  protected void doDelete(HttpServletRequest request, HttpServletResponse response) {
    refuseUnlessDone(
        services().accounts().delete(user(request).id(), Caller.of(request).name()), request);
    response.setStatus(HttpServletResponse.SC_NO_CONTENT);
  }

  /** A new password. */
  @Override
  protected void doPost(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Account user = user(request);
    Caller caller = Caller.of(request);
    Texts texts = Texts.of(request);
    FieldErrors errors = new FieldErrors();
    JsonFields fields = JsonFields.of(request, errors);
    String password = fields.text("password");
    String old = fields.text("old");
    fields.refuseUnknown();
    refuseIfAny(errors);
    new UserWishes(services(), texts, errors)
        .changePassword(caller, user, "password", password, old);
    refuseIfAny(errors);
    response.setStatus(HttpServletResponse.SC_NO_CONTENT);
  }

  /** Of others a clerk knows nothing. */
  private Account user(HttpServletRequest request) {
    Caller caller = Caller.of(request);
    return services()
        .accounts()
        .byId(Doors.number(request, "id"))
        .filter(user -> UserWishes.mayChangePassword(caller, user))
        .orElseThrow(() -> Problem.of(404, Texts.of(request).get("problem.noSuchUser")).raised());
  }

  private void refuseUnlessDone(Accounts.Outcome outcome, HttpServletRequest request) {
    new UserWishes(services(), Texts.of(request), new FieldErrors())
        .refusal(outcome)
        .ifPresent(
            sentence -> {
              throw Problem.of(409, sentence).raised();
            });
  }
}
