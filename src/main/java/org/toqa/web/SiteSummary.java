package org.toqa.web;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.accounts.Site;

/**
 * A site as administrators see it in a list.
 *
 * @param failure why it cannot be used now, in English; null: it can
 * @param openTasks how many of its tasks have not ended
 */
public record SiteSummary(
    String name,
    State state,
    @Nullable String failure,
    int floors,
    int robots,
    int openTasks,
    int users) {
  /** Whether its people can use it. */
  public enum State {
    READY,
    FAILED
  }

  public static SiteSummary of(Services services) {
    List<FloorSummary> floors = FloorSummary.all(services);
    return new SiteSummary(
        services.site().name(),
        State.READY,
        null,
        floors.size(),
        floors.stream().mapToInt(FloorSummary::robots).sum(),
        floors.stream().mapToInt(FloorSummary::openTasks).sum(),
        services.accounts().accounts().size());
  }

  public static SiteSummary failed(Site site, String failure) {
    return new SiteSummary(site.name(), State.FAILED, failure, 0, 0, 0, 0);
  }
}
