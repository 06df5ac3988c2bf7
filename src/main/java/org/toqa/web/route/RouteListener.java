package org.toqa.web.route;

import jakarta.servlet.MultipartConfigElement;
import jakarta.servlet.ServletContext;
import jakarta.servlet.ServletContextEvent;
import jakarta.servlet.ServletContextListener;
import jakarta.servlet.ServletRegistration;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.toqa.web.PagePaths;
import org.toqa.web.live.EventStreams;
import org.toqa.web.page.ShownOnce;

/**
 * Registers what the table of {@link Routes} names. {@code web.xml} names this listener, so that
 * every container calls it and lets it register servlets (Servlet specification 4.4).
 */
public final class RouteListener implements ServletContextListener {
  /** Bytes; more than a table or a map may have: the page says what is too large. */
  private static final long MAX_MULTIPART_BYTES = 40 * 1024 * 1024;

  /** Bytes of a file that are kept in memory. */
  private static final int MULTIPART_THRESHOLD_BYTES = 1024 * 1024;

  @Override
  public void contextInitialized(ServletContextEvent event) {
    ServletContext context = event.getServletContext();
    context.setAttribute(PagePaths.ATTRIBUTE, (PagePaths) Routes::isPage);
    context.setAttribute(EventStreams.ATTRIBUTE, new EventStreams());
    context.setAttribute(ShownOnce.ATTRIBUTE, new ShownOnce());
    Set<String> multipart = multipartPatterns();
    register(context, "router", plainPatterns());
    // elsewhere no body but a form's fields is read before the handler asks for it
    register(context, "multipart-router", multipart)
        .setMultipartConfig(
            new MultipartConfigElement("", -1, MAX_MULTIPART_BYTES, MULTIPART_THRESHOLD_BYTES));
  }

  @Override
  public void contextDestroyed(ServletContextEvent event) {
    EventStreams.of(event.getServletContext()).close();
  }

  static Set<String> multipartPatterns() {
    return patterns(route -> route.has(Route.Option.MULTIPART));
  }

  static Set<String> plainPatterns() {
    Set<String> patterns = patterns(route -> route.handler() != null);
    patterns.removeAll(multipartPatterns());
    return patterns;
  }

  private static Set<String> patterns(Predicate<Route> isWanted) {
    return Routes.all().stream()
        .filter(isWanted)
        .map(Route::urlPattern)
        .collect(Collectors.toCollection(TreeSet::new));
  }

  private static ServletRegistration.Dynamic register(
      ServletContext context, String name, Set<String> patterns) {
    ServletRegistration.Dynamic servlet = context.addServlet(name, new RouterServlet());
    servlet.setAsyncSupported(true);
    Set<String> taken = servlet.addMapping(patterns.toArray(String[]::new));
    if (!taken.isEmpty()) {
      throw new IllegalStateException("Another servlet answers at " + taken + ".");
    }
    return servlet;
  }
}
