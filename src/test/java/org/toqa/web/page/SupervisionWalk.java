package org.toqa.web.page;

import static com.microsoft.playwright.assertions.PlaywrightAssertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.toqa.testbed.Hall.seeing;
import static org.toqa.testbed.Hall.withArm;
import static org.toqa.web.page.PagesInBrowser.DARK;
import static org.toqa.web.page.PagesInBrowser.DESK;
import static org.toqa.web.page.PagesInBrowser.PHONE;
import static org.toqa.web.page.PagesInBrowser.assertFits;
import static org.toqa.web.page.PagesInBrowser.click;
import static org.toqa.web.page.PagesInBrowser.pictureOf;
import static org.toqa.web.page.PagesInBrowser.robot;

import com.microsoft.playwright.Locator;
import com.microsoft.playwright.Page;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.toqa.accounts.Role;
import org.toqa.fleet.FloorView.BoxView;
import org.toqa.fleet.RobotState;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage.SeenBox;
import org.toqa.mission.TaskState;
import org.toqa.testbed.BrowserTest;
import org.toqa.testbed.Views;
import org.toqa.web.TestClient;
import org.toqa.web.WebTestServer;

/** A manager starts a supervisor on its page, watches and helps it, and stops it. */
final class SupervisionWalk {
  private static final Vec2 PLACE = new Vec2(2.25, 3.45);
  private static final String PATH = "floors/hall/supervision";

  private final List<String> faults = new ArrayList<>();

  private final WebTestServer server;
  private final Page page;

  SupervisionWalk(WebTestServer server, Page page) {
    this.server = server;
    this.page = page;
  }

  /** From the page of the floors; the answer is what is in somebody's way. */
  List<String> walk() {
    server
        .fleet()
        .setRobots(
            withArm(robot("r1", RobotState.IDLE, new Pose(1.05, 0.75, 0))),
            withArm(robot("r2", RobotState.IDLE, new Pose(2.25, 0.75, 0))),
            seeing(robot("r3", RobotState.IDLE, new Pose(3.45, 0.75, 0)), new SeenBox(1, PLACE)));
    click(page.locator("tbody a[href$='/" + PATH + "']"));
    assertThat(page.locator("#live")).containsText("No supervisor has worked");
    start();
    carry();
    leaveOut();
    stop();
    return faults;
  }

  /** The robots that can do it are chosen already; what is wrong is said at its field. */
  private void start() {
    Locator boxes = page.locator("#boxTargets");
    assertThat(page.locator("#supervisor")).hasValue("r3");
    assertThat(page.locator("[name=workers]:checked")).hasCount(2);
    for (Map.Entry<String, String> wrong :
        Map.of(
                "", "At least one box",
                "1: 9", "Line “1: 9”",
                "1: 9, north", "Line “1: 9, north”",
                "1: 9 1.05\n1: 9 3", "no other box has",
                "1: 90, 90", "No arm reaches the target of box 1")
            .entrySet()) {
      boxes.fill(wrong.getKey());
      click(page.locator("#start button"));
      assertThat(page.locator("#boxes-help")).containsText(wrong.getValue());
      assertThat(boxes).hasValue(wrong.getKey());
    }
    look("refused");
    boxes.fill("1: 9, 1.05\n2: 9;3,45\n");
    click(page.locator("#start button"));
    assertThat(page.locator(".notice.good")).containsText("has begun");
    assertThat(page.locator("[data-box='1'] .state")).hasText("Looked for");
    assertThat(page.locator("#start")).hasCount(0);
  }

  /** What the cameras see becomes a task; the page follows, and says who asks for what. */
  private void carry() {
    server.supervisor().look();
    Locator box = page.locator("[data-box='1']");
    assertThat(box.locator(".state")).hasText("Waits for a worker");
    server.fleet().changeTask(1, TaskState.CARRYING, List.of("r1"), "r1 carries the load.");
    assertThat(box.locator(".state")).hasText("Carried");
    assertThat(box).containsText("In the hand");
    assertThat(page.locator("#robots tbody tr").nth(1)).containsText("1");
    assertThat(page.locator("#delivered")).hasText("0 of 2");
    look("running");

    page.navigate(server.root() + "map");
    click(page.locator("#floors a[href$='/" + PATH + "']"));
    page.navigate(server.root() + "map");
    assertThat(page.locator("#age")).containsText("Live");
    Object before = pictureOf(page);
    server
        .fleet()
        .changeFloor(
            Views.floorWith("hall", List.of())
                .withBoxes(List.of(new BoxView(2, new Vec2(6, 4), false))));
    BrowserTest.await(page, () -> !pictureOf(page).equals(before));
    page.navigate(server.root() + PATH);
  }

  /** Operators may say that a box is gone; nobody may while a robot is about it. */
  private void leaveOut() {
    server.addUser("Olga", null, Role.OPERATOR);
    try (TestClient operator = TestClient.signedIn(server.root(), "Olga")) {
      assertEquals(409, operator.post(PATH + "/boxes/1/leave-out", Map.of()).statusCode());
      assertEquals(404, operator.post(PATH + "/boxes/9/leave-out", Map.of()).statusCode());
      assertEquals(303, operator.post(PATH + "/look", Map.of()).statusCode());
      assertEquals(403, operator.post(PATH + "/stop", Map.of()).statusCode());
    }
    Locator box = page.locator("[data-box='2']");
    click(box.locator("summary"));
    click(box.getByText("Leave box 2 out", PagesInBrowser.exactly()));
    assertThat(page.locator(".notice.good")).containsText("left out");
    assertThat(box).hasCount(0);
  }

  private void stop() {
    click(page.locator("#live > details summary"));
    click(page.locator("form[action$='/stop'] button"));
    assertThat(page.locator("#live .state").first()).hasText("Stopped");
    assertThat(page.locator("#boxTargets")).hasValue("1: 9.0, 1.05");
    page.navigate(server.root() + "language/ar?back=/" + PATH);
    assertThat(page.locator("#live .state").first()).hasText("أُوقف");
    look("stopped-ar");
  }

  private void look(String name) {
    assertFits(page, "supervision-" + name, PHONE, DARK);
    faults.addAll(Accessibility.faultsOfColours(page, name + " in the dark"));
    assertFits(page, "supervision-" + name, DESK);
    faults.addAll(Accessibility.faults(page, name));
  }
}
