package org.toqa.web.page;

import static com.microsoft.playwright.assertions.PlaywrightAssertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.microsoft.playwright.Download;
import com.microsoft.playwright.Locator;
import com.microsoft.playwright.Page;
import com.microsoft.playwright.options.AriaRole;
import java.net.http.HttpResponse;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.toqa.lab.Experiments;
import org.toqa.lab.experiment.Report;
import org.toqa.lab.experiment.Run;
import org.toqa.lab.record.LabOrder;
import org.toqa.lab.record.LabRun;
import org.toqa.lab.record.LabRunState;
import org.toqa.lab.record.Laboratory.Ordered;
import org.toqa.lab.record.ReportJson;
import org.toqa.web.TestClient;
import org.toqa.web.WebTestServer;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Experiments are started, watched, stopped, compared and taken home in a real browser. */
class LaboratoryInBrowserTest extends PagesInBrowser {
  private static final Pattern RUN = Pattern.compile(".*/laboratory/runs/[0-9]+");

  @Test
  void aRunIsStartedWatchedComparedTakenHomeAndDeleted() throws Exception {
    Page page = loggedIn(WebTestServer.MANAGER, DESK, "laboratory");
    assertThat(page.locator(".experiment")).hasCount(Experiments.all().size());
    Locator form = page.locator("#csm-static");
    click(form.getByText("Start…"));
    form.getByLabel("Seed").fill("7");
    form.locator("[name='parameter.lag']").fill("9");
    assertFits(page, "laboratory-start", PHONE, DESK);
    click(form.getByText("Start run"));
    assertThat(form.locator("small").first()).hasText("Enter a number from 0 to 0.5.");
    assertThat(form.getByLabel("Seed")).hasValue("7");
    form.locator("[name='parameter.lag']").fill("0.2");
    click(form.getByText("Start run"));

    page.waitForURL(RUN);
    assertThat(page.locator(".heading .state")).hasText("Done"); // the page looks by itself
    Locator row =
        page.locator(".figures-table tr")
            .filter(new Locator.FilterOptions().setHasText("y at the end of equation 14"));
    assertThat(row).containsText("173.07 cm");
    assertThat(row).containsText("refuted");
    List<String> faults = new ArrayList<>(Accessibility.faults(page, "run"));
    assertFits(page, "laboratory-run", PHONE, DARK, DESK);
    faults.addAll(Accessibility.faultsOfColours(page, "run"));

    Locator scene = page.locator("[data-motion]").first();
    Locator body = scene.locator("circle").first();
    String start = body.getAttribute("cx");
    click(scene.getByText("Play"));
    assertThat(body).not().hasAttribute("cx", start);
    click(scene.getByText("Pause"));
    scene.getByRole(AriaRole.SLIDER).fill("0");
    assertThat(body).hasAttribute("cx", start);

    JsonNode report = JsonMapper.shared().readTree(downloaded(page, "Report (JSON)"));
    assertEquals(figures(Map.of("lag", 0.2)), report.path("figures"));
    assertTrue(downloaded(page, "Figures (CSV)").startsWith("name,published,measured,bound,"));
    assertTrue(downloaded(page, "Download CSV").startsWith("robot,straight line,"));
    assertTrue(downloaded(page, "Download SVG").contains("<svg xmlns="));

    LabRun other = start(new LabOrder("csm-static", 8, 1, Map.of()));
    page.navigate(server.root() + "laboratory");
    assertThat(page.locator("[data-run-state=DONE]")).hasCount(2);
    faults.addAll(Accessibility.faults(page, "laboratory"));
    assertFits(page, "laboratory", PHONE, DARK, DESK);
    for (Locator box : page.locator("[name=run]").all()) {
      box.check();
    }
    click(page.getByText("Compare selected"));
    assertThat(page.locator(".comparison thead")).containsText("Run " + other.id());
    assertThat(
            page.locator(".comparison tr")
                .filter(new Locator.FilterOptions().setHasText("lag"))
                .locator("td"))
        .hasText(new String[] {"", "0.05", "0.2"});
    faults.addAll(Accessibility.faults(page, "comparison"));
    assertFits(page, "laboratory-comparison", PHONE, DESK);

    page.navigate(server.root() + "language/ar?back=/laboratory/runs/" + other.id());
    assertThat(page.locator(".heading .state")).hasText("اكتملت");
    assertFits(page, "laboratory-run-ar", DESK, PHONE);
    faults.addAll(Accessibility.faults(page, "run in Arabic"));
    page.navigate(server.root() + "laboratory");
    assertFits(page, "laboratory-ar", DESK, PHONE);
    faults.addAll(Accessibility.faults(page, "laboratory in Arabic"));
    page.navigate(server.root() + "language/en?back=/laboratory/runs/" + other.id());
    click(page.locator("main summary"));
    click(page.getByText("Confirm deletion"));
    assertThat(page.getByRole(AriaRole.STATUS)).containsText("The result was deleted.");
    assertThat(page.locator("tbody tr")).hasCount(1);
    assertEquals(List.of(), faults);
  }

  @Test
  void aRunShowsItsProgressOutlivesItsPageAndIsStopped() {
    LabRun endless = start(new LabOrder("virtual-leader-limits", 1, 10_000, Map.of()));
    LabRun waits = start(new LabOrder("csm-static", 1, 1, Map.of()));
    Page first = loggedIn(WebTestServer.MANAGER, DESK, "laboratory/runs/" + endless.id());
    assertThat(first.locator(".heading .state")).hasText("Running");
    assertThat(first.locator("[data-step]")).hasText("as published, law published");
    assertFits(first, "laboratory-running", PHONE, DESK);
    first.close();

    Page page = loggedIn(WebTestServer.MANAGER, DESK, "laboratory");
    Locator row = page.locator("[data-run='" + endless.id() + "']");
    assertThat(row.locator("progress")).isVisible();
    assertThat(page.locator("[data-run='" + waits.id() + "'] .state")).hasText("Waiting");
    click(row.getByRole(AriaRole.LINK).first());
    click(page.locator("main").getByText("Stop", exactly()));
    assertThat(page.locator(".heading .state")).hasText("Stopped");
    await(
        page,
        () ->
            server.laboratory().store().run(waits.id()).orElseThrow().state() == LabRunState.DONE);
  }

  @Test
  void programsDoTheSameByTheApi() {
    try (TestClient manager = TestClient.signedIn(server.root(), WebTestServer.MANAGER)) {
      JsonNode experiments = json(manager.get("api/v1/laboratory/experiments"));
      assertEquals(Experiments.all().size(), experiments.size());
      JsonNode refused =
          json(
              manager.postJson(
                  "api/v1/laboratory/runs",
                  "{\"experiment\":\"csm-static\",\"runs\":0,\"parameters\":{\"lag\":9,\"leg\":1}}"));
      assertEquals(
          List.of("runs", "parameters.lag", "parameters.leg"),
          refused.path("errors").valueStream().map(e -> e.path("field").stringValue()).toList());

      JsonNode started =
          json(
              manager.postJson(
                  "api/v1/laboratory/runs",
                  "{\"experiment\":\"four-agents\",\"seed\":2,\"parameters\":{\"noise\":0}}"));
      String run = "api/v1/laboratory/runs/" + started.path("id").intValue();
      assertEquals("QUEUED", started.path("state").stringValue());
      assertEquals(404, manager.get(run + "/report").statusCode());
      assertEquals(409, manager.sendJson("DELETE", run, "").statusCode());
      await(page(), () -> json(manager.get(run)).path("state").stringValue().equals("DONE"));
      assertEquals(2, json(manager.get(run + "/report")).path("seed").intValue());
      JsonNode scene = json(manager.get(run + "/scenes/cluttered-both"));
      assertTrue(scene.path("bodies").size() > 1, scene::toString);
      assertEquals(404, manager.get(run + "/scenes/navigation-surface").statusCode());
      assertTrue(manager.get(run + "/drawings/cluttered-both").body().contains("<svg"));
      assertTrue(manager.get(run + "/tables/scenes").body().startsWith("scene,arrived,"));
      assertEquals(409, manager.sendJson("POST", run + "/stop", "").statusCode());
      assertEquals(204, manager.sendJson("DELETE", run, "").statusCode());
      assertEquals(404, manager.get(run).statusCode());
    }
  }

  private static JsonNode json(HttpResponse<String> answer) {
    return JsonMapper.shared().readTree(answer.body());
  }

  @Test
  void clerksDoNotSeeTheLaboratory() {
    Page page = loggedIn(WebTestServer.CLERK, DESK, "tasks");
    assertThat(page.getByRole(AriaRole.LINK, link("Laboratory"))).hasCount(0);
    page.navigate(server.root() + "laboratory");
    assertThat(page.locator("main")).containsText("Access denied");
  }

  private LabRun start(LabOrder order) {
    return switch (server.laboratory().start(order, WebTestServer.MANAGER)) {
      case Ordered.Queued(LabRun run) -> run;
      case Ordered refused -> throw new IllegalStateException(refused.toString());
    };
  }

  /** As {@code ./toqa lab csm-static --seed 7} has them. */
  private static JsonNode figures(Map<String, Double> values) {
    var experiment = Experiments.named("csm-static").orElseThrow();
    Run run = new Run(7, 1, values, (share, step) -> {}, () -> false);
    Report report = experiment.run(run);
    return JsonMapper.shared().readTree(ReportJson.text(experiment, run, report)).path("figures");
  }

  private static String downloaded(Page page, String link) throws Exception {
    Download download =
        page.waitForDownload(() -> page.locator("main").getByText(link, exactly()).first().click());
    return Files.readString(download.path());
  }
}
