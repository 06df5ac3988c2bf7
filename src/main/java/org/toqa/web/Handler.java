package org.toqa.web;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;

/**
 * Answers the requests of one route. It keeps nothing between two of them; any number of threads
 * call it at once.
 */
@FunctionalInterface
public interface Handler {
  void handle(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException;
}
