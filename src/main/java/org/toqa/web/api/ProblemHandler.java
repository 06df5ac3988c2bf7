package org.toqa.web.api;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.toqa.fleet.CheckRefusedException;
import org.toqa.persistence.StoreException;
import org.toqa.web.ErrorResponse;
import org.toqa.web.Handler;

/** Answers as another handler does; the problems that it raises become answers. */
public record ProblemHandler(Handler handler) implements Handler {

  @Override
  public void handle(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    try {
      handler.handle(request, response);
    } catch (Problem.ProblemException e) {
      e.problem().send(request, response);
    } catch (StoreException e) {
      if (e.kind() == StoreException.Kind.UNKNOWN_USER) {
        response.setHeader("WWW-Authenticate", "Bearer");
      }
      Problem.of(ErrorResponse.status(e), ErrorResponse.sentence(request, e))
          .send(request, response);
    } catch (CheckRefusedException e) {
      Problem.of(ErrorResponse.status(response, e), ErrorResponse.sentence(request, e))
          .send(request, response);
    }
  }
}
