package org.toqa.web.route;

import jakarta.servlet.FilterChain;
import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpFilter;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Optional;
import org.toqa.web.Services;
import org.toqa.web.access.Credential;

/**
 * Counts a request by its address before the database is asked whose it is, unless it shows what
 * was somebody's a moment ago: an invented cookie or token costs no query where its address asks
 * too fast.
 */
public final class AddressLimitFilter extends HttpFilter {
  @Override
  protected void doFilter(
      HttpServletRequest request, HttpServletResponse response, FilterChain chain)
      throws IOException, ServletException {
    Optional<Credential> shown = Credential.of(request);
    boolean isKnown =
        shown
            .filter(
                credential ->
                    Services.of(request.getServletContext())
                        .requestLimit()
                        .isKnown(credential.secret()))
            .isPresent();
    if (isKnown
        || RequestLimitFilter.isUnlimited(request)
        || RequestLimitFilter.tryAcquireByAddress(request, response)) {
      chain.doFilter(request, response);
    }
  }
}
