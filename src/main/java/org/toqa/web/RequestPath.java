package org.toqa.web;

import jakarta.servlet.ServletRequest;
import jakarta.servlet.http.HttpServletRequest;
import java.net.URLEncoder;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.Objects;

/** The path that a request asks for, and its parameters. */
public final class RequestPath {
  private static final String PARAMETERS = RequestPath.class.getName();
  private static final String NUMBER = "[1-9][0-9]{0,17}";

  private RequestPath() {}

  /** The path from the application's root. */
  public static String of(HttpServletRequest request) {
    String rest = request.getPathInfo();
    return rest == null ? request.getServletPath() : request.getServletPath() + rest;
  }

  /** Whether the API answers there, in JSON; elsewhere are pages. */
  public static boolean isApi(String path) {
    return path.startsWith("/api/");
  }

  /**
   * @param parameters the value of each segment in braces of its route
   */
  public static void storeParameters(ServletRequest request, Map<String, String> parameters) {
    request.setAttribute(PARAMETERS, parameters);
  }

  /**
   * The part of the request's path at {@code {name}}.
   *
   * @throws NullPointerException when the route has no such segment
   */
  public static String parameter(ServletRequest request, String name) {
    Map<?, ?> parameters = (Map<?, ?>) request.getAttribute(PARAMETERS);
    return (String) Objects.requireNonNull(parameters.get(name), name);
  }

  /** The number in the path at {@code {name}}, or 0, which nothing has. */
  public static long number(ServletRequest request, String name) {
    String given = parameter(request, name);
    return given.matches(NUMBER) ? Long.parseLong(given) : 0;
  }

  /** A name as a segment of an address. */
  public static String segment(String name) {
    return URLEncoder.encode(name, StandardCharsets.UTF_8).replace("+", "%20");
  }

  /** Where the browser found these pages, without a slash at its end. */
  public static String baseUrl(HttpServletRequest request) {
    String url = request.getRequestURL().toString();
    return url.substring(0, url.length() - request.getRequestURI().length())
        + request.getContextPath();
  }
}
