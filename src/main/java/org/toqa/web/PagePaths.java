package org.toqa.web;

import jakarta.servlet.ServletContext;
import java.util.Objects;

/** The paths at which pages are shown to those who may see them. */
@FunctionalInterface
public interface PagePaths {
  /** The servlet context's attribute that holds them. */
  String ATTRIBUTE = PagePaths.class.getName();

  boolean contains(String path);

  static PagePaths of(ServletContext context) {
    return (PagePaths)
        Objects.requireNonNull(
            context.getAttribute(ATTRIBUTE), "The page paths are not in the servlet context.");
  }
}
