package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.List;
import org.toqa.accounts.Account;
import org.toqa.accounts.Role;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.InputRules;
import org.toqa.web.input.JsonFields;

/** The users: a manager sees all and adds some, a clerk sees himself. */
public final class UsersResource extends ApiHandler {
  public static void list(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Caller caller = Caller.of(request);
    List<Account> users =
        caller.isManager() ? services(request).accounts().accounts() : List.of(caller.account());
    Json.send(request, response, 200, users.stream().map(UserJson::of).toList());
  }

  public static void add(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    FieldErrors errors = new FieldErrors();
    JsonFields fields = JsonBody.read(request, errors);
    Texts texts = Texts.of(request);
    InputRules rules = new InputRules(texts, errors);
    String name = rules.userName("name", fields.text("name"));
    String password = rules.newPassword("password", fields.text("password"), name);
    String email = rules.email("email", fields.text("email"));
    Role role = rules.role("role", fields.text("role"), Caller.of(request));
    fields.refuseUnknown();
    throwIfAny(errors);
    Account user =
        services(request)
            .accounts()
            .add(
                name,
                email,
                services(request).passwordHasher().hash(password),
                role,
                Caller.of(request).name())
            .orElseThrow(() -> Problem.of(409, texts.get("error.userName.taken")).exception());
    response.setHeader("Location", request.getContextPath() + "/api/v1/users/" + user.id());
    Json.send(request, response, HttpServletResponse.SC_CREATED, UserJson.of(user));
  }
}
