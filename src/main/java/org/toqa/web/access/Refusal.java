package org.toqa.web.access;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.toqa.web.Door;
import org.toqa.web.Doors;
import org.toqa.web.Texts;
import org.toqa.web.api.Problem;
import org.toqa.web.page.ErrorServlet;

/** The no to a request that reaches no servlet: a problem for the API, else a page. */
final class Refusal {
  private Refusal() {}

  static void send(
      HttpServletRequest request,
      HttpServletResponse response,
      int status,
      String key,
      Object... values)
      throws IOException {
    String sentence = Texts.of(request).get(key, values);
    if (Door.isApi(Doors.pathOf(request))) {
      Problem.of(status, sentence).send(request, response);
    } else {
      ErrorServlet.send(request, response, status, sentence);
    }
  }
}
