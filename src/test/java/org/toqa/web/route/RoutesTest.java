package org.toqa.web.route;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

/** What must hold for the table of routes, and how its paths become patterns of the container. */
class RoutesTest {

  @Test
  void everyRouteButTheFilesHasAHandler() {
    List<String> withoutHandler =
        Routes.all().stream().filter(route -> route.handler() == null).map(Route::path).toList();

    assertEquals(List.of("/assets/*"), withoutHandler);
  }

  @Test
  void noTwoRoutesHaveOneMethodAndPath() {
    Set<String> seen = new HashSet<>();
    for (Route route : Routes.all()) {
      assertTrue(seen.add(route.method() + " " + route.path()), route.toString());
    }
  }

  @Test
  void onlyTablesAndMapsAreTakenAsFiles() {
    assertEquals(Set.of("/floors", "/tasks/import"), RouteListener.multipartPatterns());
  }

  @Test
  void noPatternIsRegisteredTwice() {
    Set<String> both = new TreeSet<>(RouteListener.plainPatterns());
    both.retainAll(RouteListener.multipartPatterns());

    assertEquals(Set.of(), both);
  }

  @Test
  void everyRouteIsUnderAPatternOfItsRouter() {
    Set<String> patterns = RouteListener.plainPatterns();
    for (String pattern :
        List.of("", "/map", "/tasks/*", "/language/*", "/api/v1/tasks/*", "/api/v1/users/*")) {
      assertTrue(patterns.contains(pattern), pattern);
    }
  }

  @Test
  void aFixedSegmentGoesBeforeAParameter() {
    assertEquals("/tasks/new", path("/tasks/new"));
    assertEquals("/tasks/{id}", path("/tasks/7"));
  }

  @Test
  void locatingARobotIsARouteOfItsOwnAndNothingElseIs() {
    assertEquals("/robots/{name}/locate", path("/robots/r1/locate"));
    assertTrue(Routes.find("/robots/r1/anything").isEmpty());
  }

  private static String path(String asked) {
    return Routes.find(asked).orElseThrow().routes().getFirst().path();
  }
}
