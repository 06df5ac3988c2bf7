package org.toqa.web.input;

import jakarta.servlet.http.HttpServletRequest;
import org.toqa.fleet.Answer;
import org.toqa.web.FleetAnswers;
import org.toqa.web.Services;
import org.toqa.web.SiteSummary;
import org.toqa.web.Sites;

/**
 * A site that somebody wants to make, with its first manager.
 *
 * @param name of the site
 * @param manager the manager's name
 * @param password the manager's
 */
public record SiteOrder(String name, String manager, String password) {

  /** It means something only when no error was filed. */
  public static SiteOrder read(Fields fields) {
    InputRules rules = new InputRules(fields.texts(), fields.errors());
    String name = rules.siteName("name", fields.text("name"));
    String manager = rules.userName("manager", fields.text("manager"));
    return new SiteOrder(
        name, manager, rules.newPassword("password", fields.text("password"), manager));
  }

  /**
   * Has it made.
   *
   * @param by who does it
   */
  public Answer<SiteSummary> place(HttpServletRequest request, String by) {
    String hash = Services.of(request).passwordHasher().hash(password);
    return FleetAnswers.await(
        Sites.of(request.getServletContext()).add(name, manager, hash, by), Sites.ADD_LIMIT);
  }

  /** Without the password, so that it reaches no log. */
  @Override
  public String toString() {
    return "SiteOrder[" + name + ", " + manager + "]";
  }
}
