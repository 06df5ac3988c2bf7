package org.toqa.web.route;

import jakarta.servlet.ServletContextEvent;
import jakarta.servlet.ServletContextListener;
import org.toqa.web.PagePaths;

/** Tells the application which paths have pages. {@code web.xml} names it. */
public final class RouteListener implements ServletContextListener {
  @Override
  public void contextInitialized(ServletContextEvent event) {
    event.getServletContext().setAttribute(PagePaths.ATTRIBUTE, (PagePaths) Routes::isPage);
  }
}
