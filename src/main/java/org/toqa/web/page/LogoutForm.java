package org.toqa.web.page;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.toqa.web.access.SessionCookie;
import org.toqa.web.access.VisitedSite;

/** Signs out. */
public final class LogoutForm extends PageHandler {
  public static void signOut(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    SessionCookie.signOut(request);
    VisitedSite.forget(request, response);
    redirect(request, response, "/");
  }
}
