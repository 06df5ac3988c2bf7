package org.toqa.web.page;

import jakarta.servlet.http.HttpServletRequest;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Which page of a long list is shown; the view {@code pages.tag} finds it in the request.
 *
 * @param number from 1; beyond the last page it is the last
 * @param pages at least 1
 * @param size how many entries a page has
 */
record ListPage(int number, int pages, int size) {
  /**
   * The page that the query's {@code page} names, else the first.
   *
   * @param count of the whole list
   */
  static ListPage of(HttpServletRequest request, long count, int size) {
    int pages = (int) Math.max(1, (count + size - 1) / size);
    ListPage page =
        new ListPage(Math.min(pages, wanted(request.getParameter("page"))), pages, size);
    request.setAttribute("page", page.number);
    request.setAttribute("pages", pages);
    return page;
  }

  /** How many entries are before it. */
  int offset() {
    return (number - 1) * size;
  }

  /** What of the whole list is on it. */
  <T> List<T> of(List<T> all) {
    return all.subList(offset(), Math.min(all.size(), offset() + size));
  }

  private static int wanted(@Nullable String given) {
    return given != null && given.matches("[1-9][0-9]{0,6}") ? Integer.parseInt(given) : 1;
  }
}
