package org.toqa.web.page;

import jakarta.servlet.DispatcherType;
import jakarta.servlet.RequestDispatcher;
import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServlet;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.toqa.persistence.StoreException;
import org.toqa.web.ErrorResponse;
import org.toqa.web.FleetUnavailableException;
import org.toqa.web.RequestPath;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.api.Problem;

/** Shows every error as a page in the style of the others, or as a problem where the API was. */
public final class ErrorServlet extends HttpServlet {
  @Override
  protected void service(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    if (request.getDispatcherType() != DispatcherType.ERROR) {
      response.sendError(HttpServletResponse.SC_NOT_FOUND);
      return;
    }
    int status = status(request);
    if (status == HttpServletResponse.SC_UNAUTHORIZED && !isForApi(request)) {
      PageHandler.redirect(request, response, "/"); // as of everybody who is not logged in
      return;
    }
    String sentence = sentence(request, status);
    response.setStatus(status);
    ErrorResponse.sayWhenToRetry(response, status);
    if (isForApi(request)) {
      Problem.of(status, sentence).send(request, response);
      return;
    }
    Texts texts = Texts.of(request);
    request.setAttribute("status", status);
    request.setAttribute("sentence", sentence);
    request.setAttribute("heading", texts.get(headingKey(status)));
    if (Caller.find(request).isPresent()) {
      PageHandler.show(request, response, "error");
    } else {
      PageHandler.showWithoutForm(request, response, "error");
    }
  }

  private static int status(HttpServletRequest request) {
    Object cause = cause(request);
    if (cause instanceof StoreException failure) {
      return ErrorResponse.status(failure);
    }
    if (cause instanceof FleetUnavailableException) {
      return HttpServletResponse.SC_SERVICE_UNAVAILABLE;
    }
    return request.getAttribute(RequestDispatcher.ERROR_STATUS_CODE) instanceof Integer status
        ? status
        : HttpServletResponse.SC_INTERNAL_SERVER_ERROR;
  }

  private static String sentence(HttpServletRequest request, int status) {
    return ErrorResponse.sentence(request).orElseGet(() -> sentenceOf(request, status));
  }

  private static String sentenceOf(HttpServletRequest request, int status) {
    if (cause(request) instanceof StoreException failure) {
      return ErrorResponse.sentence(request, failure);
    }
    return Texts.of(request)
        .get(
            switch (status) {
              case 404 -> "problem.noSuchPage";
              case 413 -> "problem.tooLarge";
              case 503 -> "problem.fleetTimeout";
              default -> status < 500 ? "problem.badRequest" : "problem.serverError";
            });
  }

  private static String headingKey(int status) {
    return switch (status) {
      case 403, 404, 405, 429, 503 -> "error.heading." + status;
      default -> status < 500 ? "error.heading.400" : "error.heading.500";
    };
  }

  private static Object cause(HttpServletRequest request) {
    Object thrown = request.getAttribute(RequestDispatcher.ERROR_EXCEPTION);
    return thrown instanceof ServletException e && e.getRootCause() != null
        ? e.getRootCause()
        : thrown;
  }

  private static boolean isForApi(HttpServletRequest request) {
    return request.getAttribute(RequestDispatcher.ERROR_REQUEST_URI) instanceof String uri
        && uri.startsWith(request.getContextPath())
        && RequestPath.isApi(uri.substring(request.getContextPath().length()));
  }
}
