package org.toqa.web.page;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.toqa.web.access.SessionCookie;

/** The way out. */
public final class LogoutServlet extends PageServlet {
  @Override
  protected void doPost(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    SessionCookie.signOut(request, services());
    redirect(request, response, "/");
  }
}
