package org.toqa.web.input;

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

  /** Without the password, so that it reaches no log. */
  @Override
  public String toString() {
    return "SiteOrder[" + name + ", " + manager + "]";
  }
}
