package org.toqa.web.route;

import jakarta.servlet.FilterChain;
import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpFilter;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Optional;
import org.toqa.accounts.AddressBlock;
import org.toqa.web.ConcurrencyLimit;
import org.toqa.web.ErrorResponse;
import org.toqa.web.Services;
import org.toqa.web.access.Credential;

/**
 * Counts a request by its address before the database is asked whose it is, unless it shows what
 * was somebody's a moment ago: an invented cookie or token costs no query where its address asks
 * too fast. Of one address so many are answered at once; a proxy's callers count each by his own.
 */
public final class AddressLimitFilter extends HttpFilter {
  @Override
  protected void doFilter(
      HttpServletRequest request, HttpServletResponse response, FilterChain chain)
      throws IOException, ServletException {
    Optional<Credential> shown = Credential.of(request);
    boolean isKnown =
        shown
            .filter(credential -> Services.of(request).requestLimit().isKnown(credential.secret()))
            .isPresent();
    if (isKnown
        || RequestLimitFilter.isUnlimited(request)
        || RequestLimitFilter.tryAcquireByAddress(request, response)) {
      doFilterInPlace(request, response, chain);
    }
  }

  /** As one of the requests that the address may have answered at once. */
  private static void doFilterInPlace(
      HttpServletRequest request, HttpServletResponse response, FilterChain chain)
      throws IOException, ServletException {
    if (RequestLimitFilter.isUnlimited(request) || Routes.isUrgent(request)) {
      chain.doFilter(request, response);
      return;
    }
    ConcurrencyLimit limit = Services.of(request).concurrency().requests();
    String address = AddressBlock.of(request.getRemoteAddr());
    if (!limit.tryAcquire(address)) {
      response.setHeader("Retry-After", "1");
      ErrorResponse.sendText(request, response, 429, "problem.tooManyAtOnce", limit.max());
      return;
    }
    try {
      chain.doFilter(request, response);
    } finally {
      limit.release(address);
    }
  }
}
