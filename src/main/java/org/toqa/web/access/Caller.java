package org.toqa.web.access;

import jakarta.servlet.ServletRequest;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.accounts.Account;
import org.toqa.accounts.Session;
import org.toqa.accounts.Site;

/**
 * The user whose request it is, and how he proved it.
 *
 * @param site where his account is; he may look at another one
 */
public record Caller(Account account, Session session, Credential credential, Site site) {
  /** Also the name under which views find the caller. */
  private static final String ATTRIBUTE = "caller";

  public String name() {
    return account.name();
  }

  /**
   * @param owner the id of the account whose something is; null: nobody's
   */
  public boolean owns(@Nullable Long owner) {
    return owner != null && owner == account.id();
  }

  /** A name that he shares with nobody of any site. */
  public String uniqueName() {
    return site.isFirst() ? account.name() : account.name() + "@" + site.id();
  }

  public boolean isManager() {
    return account.isManager();
  }

  /** Whether he may change what the request's site has. */
  public boolean mayManage() {
    return isManager() && !isVisitor();
  }

  /** Whether he may keep robots and everybody's tasks going in the request's site. */
  public boolean mayOperate() {
    return has(Permission.OPERATE) && !isVisitor();
  }

  /** Whether he may add tasks in the request's site. */
  public boolean mayOrder() {
    return has(Permission.ORDER) && !isVisitor();
  }

  /** Whether he may pause the robots of the request's site. */
  public boolean mayPause() {
    return has(Permission.PAUSE) && !isVisitor();
  }

  /**
   * Whether he may change what somebody has ordered.
   *
   * @param owner the id of that account; null: nobody's
   */
  public boolean mayChangeOrderOf(@Nullable Long owner) {
    return has(Permission.OPERATE) || (has(Permission.ORDER) && owns(owner));
  }

  public boolean isAdministrator() {
    return account.isAdministrator();
  }

  /** Administrators are of the first site alone. */
  public boolean mayMakeAdministrators() {
    return isAdministrator() && !isVisitor();
  }

  /** Whether the request concerns another site than his own. */
  public boolean isVisitor() {
    return account.isVisitor();
  }

  /** The same where he looks at another site than his own. */
  public Caller asVisitor() {
    return new Caller(account.asVisitor(site.name()), session, credential, site);
  }

  /** Whether the caller may use a route that asks for that permission. */
  public boolean has(Permission permission) {
    return permission.power().map(account.role()::has).orElse(true);
  }

  public void storeIn(ServletRequest request) {
    request.setAttribute(ATTRIBUTE, this);
  }

  /** The caller of a route that only who is signed in may use. */
  public static Caller of(ServletRequest request) {
    return Objects.requireNonNull((@Nullable Caller) request.getAttribute(ATTRIBUTE));
  }

  public static Optional<Caller> find(ServletRequest request) {
    return Optional.ofNullable((@Nullable Caller) request.getAttribute(ATTRIBUTE));
  }
}
