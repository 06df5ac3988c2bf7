package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import org.toqa.fleet.Answer;
import org.toqa.web.FleetAnswers;
import org.toqa.web.RequestPath;
import org.toqa.web.Services;
import org.toqa.web.SiteSummary;
import org.toqa.web.Sites;
import org.toqa.web.access.Caller;
import org.toqa.web.access.VisitedSite;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.SiteOrder;

/** All sites, for administrators: they make some, look at each, and delete some. */
public final class SitesPage extends PageHandler {
  public static void show(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    addSites(request);
    show(request, response, "sites");
  }

  private static Sites sites(HttpServletRequest request) {
    return Sites.of(request.getServletContext());
  }

  private static void addSites(HttpServletRequest request) {
    request.setAttribute("sites", sites(request).all());
    VisitedSite.kept(request)
        .flatMap(sites(request)::find)
        .map(services -> services.site().name())
        .ifPresent(name -> request.setAttribute("visited", name));
  }

  public static void add(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    FieldErrors errors = new FieldErrors();
    Optional<SiteSummary> added =
        readForm(request, errors, SiteOrder::read)
            .flatMap(
                order ->
                    acceptedValue(
                        request, order.place(request, Caller.of(request).name()), errors));
    if (added.isPresent()) {
      redirect(request, response, "/sites?done=added");
    } else {
      addSites(request);
      showAgain(request, response, "sites", errors);
    }
  }

  /** From now on the pages of this browser show that site. */
  public static void visit(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Optional<Services> site = sites(request).find(RequestPath.parameter(request, "site"));
    if (site.isEmpty()) {
      sendNotFound(request, response, "problem.noSuchSite");
    } else if (site.get().site().equals(Caller.of(request).site())) {
      VisitedSite.forget(request, response);
      redirect(request, response, "/sites");
    } else {
      VisitedSite.keep(request, response, site.get().site().id());
      redirect(request, response, "/map");
    }
  }

  public static void remove(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Answer<String> answer =
        FleetAnswers.await(
            sites(request)
                .remove(RequestPath.parameter(request, "site"), Caller.of(request).name()));
    if (answer instanceof Answer.Unknown<String>) {
      sendNotFound(request, response, "problem.noSuchSite");
      return;
    }
    FieldErrors errors = new FieldErrors();
    if (acceptedValue(request, answer, errors).isPresent()) {
      redirect(request, response, "/sites?done=removed");
      return;
    }
    addSites(request);
    request.setAttribute("refusals", List.copyOf(errors.sentences().values()));
    showConflict(request, response, "sites", new FieldErrors());
  }
}
