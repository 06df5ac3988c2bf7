package org.toqa.web.page;

import static com.microsoft.playwright.assertions.PlaywrightAssertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertEquals;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import com.microsoft.playwright.Browser;
import com.microsoft.playwright.CDPSession;
import com.microsoft.playwright.Locator;
import com.microsoft.playwright.Page;
import com.microsoft.playwright.Route;
import com.microsoft.playwright.options.AriaRole;
import com.microsoft.playwright.options.FilePayload;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.FloorDraft;
import org.toqa.fleet.RobotView;
import org.toqa.grid.FloorDrawing;
import org.toqa.grid.FloorMap;
import org.toqa.grid.Moves;
import org.toqa.grid.OccupancyGrid;
import org.toqa.testbed.MapCanvas;
import org.toqa.web.WebTestServer;

/** The editor of floors in a real browser: by mouse, by keyboard, by touch, and by two at once. */
class EditorInBrowserTest extends PagesInBrowser {
  @Override
  List<RobotView> robots() {
    return List.of();
  }

  @Test
  void aFloorIsDrawnFromNothingByMouse() {
    Page page = loggedIn(WebTestServer.MANAGER, DESK, "floors");
    page.locator("#name").fill("Ümit 2");
    page.locator("#width").fill("12");
    page.locator("#height").fill("6");
    page.locator("#resolution").fill("0.3");
    button(page, "Add floor").click();
    assertThat(page.locator("tbody tr")).hasCount(2);
    picture(page, "floors");
    page.locator("tbody tr").nth(1).getByText("Edit").click();
    assertThat(page.locator("#save-state")).hasText("Nothing changed yet");

    tool(page, "rectangle");
    drag(page, 0.15, 0.15, 11.85, 5.85);
    assertThat(page.locator("#said")).hasText("116 cells became wall.");
    tool(page, "line");
    drag(page, 6.15, 5.55, 6.15, 3.15);
    tool(page, "erase");
    click(page, 6.15, 4.05);
    tool(page, "keepOut");
    drag(page, 7.5, 1.5, 8.7, 2.7);
    tool(page, "speedLimits");
    drag(page, 1.5, 3.3, 4.5, 4.5);
    page.locator("[data-field=speed]").fill("0.3");
    page.locator("[data-field=speed]").press("Tab");
    tool(page, "oneWay");
    drag(page, 1.5, 2.1, 4.5, 2.7);
    page.locator("[data-field=direction]").selectOption("west");
    tool(page, "freeZones");
    drag(page, 8.1, 3.3, 9.9, 4.8);
    tool(page, "stations");
    click(page, 1.05, 1.05);
    page.locator("[data-field=name]").fill("Dock");
    page.locator("[data-field=headingDegrees]").fill("90");
    page.locator("[data-field=headingDegrees]").press("Tab");
    page.locator("[data-field=approach]").selectOption("south");
    tool(page, "parking");
    click(page, 10.05, 1.05);
    tool(page, "charging");
    click(page, 10.05, 5.05);
    tool(page, "measure");
    drag(page, 1.05, 1.05, 4.05, 5.05);
    assertThat(page.locator("#said")).hasText("4.92 m");
    tool(page, "select");
    drag(page, 10.05, 1.05, 9.45, 1.35);
    page.getByText("How robots drive").click();
    page.locator("#moves").selectOption("smooth");
    assertThat(page.locator("#said")).hasText("Robots that meet nobody drive on a smooth curve.");
    page.locator("#undo").click();
    assertThat(page.locator("#moves")).hasValue("heading");
    page.locator("#redo").click();
    assertThat(page.locator("#moves")).hasValue("smooth");
    assertThat(page.locator("#save-state")).hasText("Draft saved");
    page.locator("#difference").click();
    assertThat(page.locator("#changes-summary"))
        .hasText(
            "New wall: 124 cells. Removed wall: 0 cells. Places and areas changed: 7."
                + " Robots that meet nobody drive on a smooth curve.");
    assertFits(page, "editor", PHONE, DARK_PHONE, DARK);
    assertEquals(List.of(), Accessibility.faultsOfColours(page, "editor in the dark"));
    assertFits(page, "editor", DESK);
    assertEquals(List.of(), Accessibility.faults(page, "editor"));
    page.locator("#difference").click();

    FloorDrawing drawing = draft("Ümit 2").drawing();
    assertEquals(124, drawing.walls().occupied().cardinality()); // 116 + 9 - 1
    assertEquals("Dock", drawing.stations().getFirst().name());
    assertEquals(Math.PI / 2, drawing.stations().getFirst().heading());
    assertEquals(9.45, drawing.parking().getFirst().position().x(), 1e-9);
    assertEquals(0.3, drawing.speedLimits().getFirst().speed());
    assertEquals(1.5, drawing.keepOut().getFirst().width(), 1e-9);

    page.locator("#publish").click();
    assertThat(page.locator("#publishing")).containsText("New wall: 124 cells");
    picture(page, "editor-publish");
    page.locator("#publish-sure").click();
    assertThat(page.locator("#problems-summary")).hasText("Published. The drawing is in force.");
    assertThat(page.locator("#save-state")).hasText("Nothing changed yet");
    FloorMap map = floor("Ümit 2");
    assertEquals(drawing.walls(), map.drawing().walls());
    assertEquals(Moves.SMOOTH, map.moves());
    page.locator("#undo").click(); // and on with the next draft
    assertThat(page.locator("#save-state")).hasText("Draft saved");
    page.locator("#discard").click();
    page.locator("#discard-sure").click();
    assertThat(page.locator("#save-state")).hasText("Nothing changed yet");
    page.locator("#undo").click();
    assertThat(page.locator("#save-state")).hasText("Draft saved");
  }

  @Test
  void everyStepIsUndoneAndDoneAgain() {
    Page page = editor(WebTestServer.MANAGER);
    int walls = floor("hall").drawing().walls().occupied().cardinality();
    tool(page, "wall");
    drag(page, 3.15, 2.25, 5.55, 2.25);
    tool(page, "stations");
    click(page, 8.25, 3.15);
    page.locator("#resize-left").evaluate("field => field.closest('details').open = true");
    page.locator("#resize-left").fill("2");
    page.locator("#resize").click();
    awaitDraft(drawing -> drawing.walls().width() == 42 && drawing.stations().size() == 3);
    assertEquals(-0.6, draft("hall").drawing().walls().origin().x(), 1e-9);

    for (int i = 0; i < 3; i++) {
      page.keyboard().press("Control+z");
    }
    assertThat(page.locator("#undo")).isDisabled();
    awaitDraft(
        drawing ->
            drawing.walls().occupied().cardinality() == walls && drawing.stations().size() == 2);
    page.keyboard().press("Control+Shift+z");
    page.locator("#redo").click();
    page.locator("#redo").click();
    assertThat(page.locator("#redo")).isDisabled();
    awaitDraft(
        drawing ->
            drawing.walls().occupied().cardinality() == walls + 9
                && drawing.walls().width() == 42
                && drawing.stations().size() == 3);
  }

  @Test
  void theKeyboardAloneIsEnough() {
    Page page = editor(WebTestServer.MANAGER);
    page.locator("[data-tool=line]").focus();
    page.keyboard().press("Enter");
    page.locator("#map").focus();
    press(page, "ArrowRight", 1); // the cursor is in the middle
    assertThat(page.locator("#said")).hasText("6.15, 3.15 m: free");
    press(page, "Enter", 1);
    assertThat(page.locator("#said")).containsText("Begun here");
    press(page, "ArrowRight", 3);
    press(page, "Enter", 1);
    assertThat(page.locator("#said")).hasText("4 cells became wall.");
    page.locator("[data-tool=charging]").focus();
    page.keyboard().press("Space");
    page.locator("#map").focus();
    press(page, "ArrowDown", 1);
    press(page, "Shift+ArrowLeft", 1);
    press(page, "Space", 1);
    assertThat(page.locator("#said")).containsText("Added: Charger");
    awaitDraft(drawing -> drawing.charging().size() == 2);
    picture(page, "editor-keyboard");
    press(page, "Delete", 1);
    awaitDraft(drawing -> drawing.charging().size() == 1);
    page.keyboard().press("Control+z");
    awaitDraft(drawing -> drawing.charging().size() == 2);
  }

  @Test
  void aFingerDrawsAndTwoMoveTheView() {
    Page page =
        loggedIn(
            WebTestServer.MANAGER,
            new Browser.NewContextOptions().setViewportSize(820, 1180).setHasTouch(true),
            "floors/hall/edit");
    assertThat(page.locator("#save-state")).hasText("Nothing changed yet");
    int walls = floor("hall").drawing().walls().occupied().cardinality();
    tool(page, "wall");
    CDPSession touch = page.context().newCDPSession(page);
    touch(touch, "touchStart", at(page, 3.15, 2.25));
    touch(touch, "touchMove", at(page, 4.05, 2.25));
    touch(touch, "touchEnd");
    awaitDraft(drawing -> drawing.walls().occupied().cardinality() == walls + 4);

    Object before = pictureOf(page);
    touch(touch, "touchStart", at(page, 3.15, 4.05));
    touch(touch, "touchStart", at(page, 3.15, 4.05), at(page, 6.15, 4.05));
    touch(touch, "touchMove", at(page, 2.15, 4.05), at(page, 8.15, 4.05));
    touch(touch, "touchEnd");
    await(page, () -> !pictureOf(page).equals(before));
    picture(page, "editor-tablet");
    assertThat(page.locator("#save-state")).hasText("Draft saved");
    assertEquals(walls + 4, draft("hall").drawing().walls().occupied().cardinality());
    page.locator("#undo").tap();
    awaitDraft(drawing -> drawing.walls().occupied().cardinality() == walls);
  }

  @Test
  void twoWhoDrawAtOnceAreToldOfEachOther() {
    Page page = editor(WebTestServer.MANAGER);
    FloorDrawing theirs = FloorDrawing.of(floor("hall").drawing().walls());
    saveElsewhere(theirs);
    tool(page, "stations");
    click(page, 8.25, 3.15);
    assertThat(page.locator("#conflict-who")).containsText("Ann saved another version at");
    picture(page, "editor-conflict");
    page.locator("#conflict-load").click();
    assertThat(page.locator("#things li")).hasCount(0);
    page.locator("#undo").click();
    assertThat(page.locator("#things li")).hasCount(7);
    awaitDraft(drawing -> drawing.stations().size() == 3);

    saveElsewhere(theirs);
    click(page, 8.25, 4.05);
    page.locator("#conflict-keep").click();
    awaitDraft(drawing -> drawing.stations().size() == 4);
    assertThat(page.locator("#save-state")).hasText("Draft saved");
  }

  @Test
  void nothingIsLostWhileTheServerIsAway() {
    Page page = editor(WebTestServer.MANAGER);
    page.route("**/draft", Route::abort);
    tool(page, "stations");
    click(page, 8.25, 3.15);
    assertThat(page.locator("#save-state")).containsText("Not saved: The server does not answer.");
    picture(page, "editor-away");
    List<String> asked = new ArrayList<>();
    page.onceDialog(
        dialog -> {
          asked.add(dialog.type());
          dialog.dismiss(); // the page is not left
        });
    page.evaluate("location.reload()");
    await(page, () -> asked.equals(List.of("beforeunload")));
    page.unroute("**/draft");
    page.evaluate("dispatchEvent(new Event('online'))");
    assertThat(page.locator("#save-state")).hasText("Draft saved");
    assertEquals(3, draft("hall").drawing().stations().size());
  }

  @Test
  void aNameThatCannotBeShownIsRefusedAtOnce() {
    Page page = editor(WebTestServer.MANAGER);
    tool(page, "stations");
    click(page, 8.25, 3.15);
    Locator name = page.locator("[data-field=name]");
    for (String wrong :
        List.of("Dock\u200f", "Dock \ue000", "Do\u0085ck", "\u200d", "a".repeat(65))) {
      name.fill(wrong);
      name.press("Tab");
      assertThat(page.locator("#thing-error"))
          .hasText(
              "Enter a name of 1 to 64 letters, all of which can be shown. Type it where a pasted"
                  + " one is not taken.");
      name.fill("Dock");
      name.press("Tab");
      assertThat(page.locator("#thing-error")).isEmpty();
    }
    name.fill("Dock\u200f");
    name.press("Tab");
    assertFits(page, "editor-name", PHONE, DESK);
    name.fill("می\u200cخواهم 👷🏽\u200d♀️");
    name.press("Tab");
    awaitDraft(drawing -> drawing.stations().getLast().name().contains("👷🏽\u200d♀️"));
  }

  @Test
  void thatTheDrawingHasChangedWhileItWasSavedIsSaid() {
    Page page = editorChangedWhile("**/draft");

    assertThat(page.locator("#said"))
        .hasText("The drawing has changed meanwhile. Check or publish it again.");
    assertThat(page.locator("#publishing")).isHidden();
    assertThat(page.locator("#problems")).isHidden();
    awaitDraft(drawing -> drawing.stations().size() == 4);
  }

  @Test
  void thatTheDrawingHasChangedWhileItWasCheckedIsSaid() {
    Page page = editorChangedWhile("**/draft/check");

    assertThat(page.locator("#problems-summary"))
        .hasText("The drawing has changed meanwhile. Check or publish it again.");
    assertThat(page.locator("#said")).hasText(page.locator("#problems-summary").textContent());
    assertThat(page.locator("#publishing")).isHidden();
    assertFits(page, "editor-changed-meanwhile", PHONE, DESK);
  }

  /** An editor in which a station was drawn on while what publishing asks was under way. */
  private Page editorChangedWhile(String asking) {
    Page page = editor(WebTestServer.MANAGER);
    tool(page, "stations");
    click(page, 8.25, 3.15);
    page.locator("#undo").click();
    assertThat(page.locator("#save-state")).hasText("Draft saved"); // by itself, after a moment
    List<Route> asked = new ArrayList<>();
    page.route(asking, asked::add);
    page.evaluate("for (const id of ['redo', 'publish']) document.getElementById(id).click()");
    await(page, () -> !asked.isEmpty());
    click(page, 8.25, 4.05);
    page.unroute(asking);
    asked.forEach(Route::resume);
    return page;
  }

  @Test
  void aPlanIsImportedAndWhatIsInItsWallsIsNotPublished() throws IOException {
    Page page = editor(WebTestServer.MANAGER);
    page.locator("#import-file").evaluate("field => field.closest('details').open = true");
    page.locator("#import-file").setInputFiles(new FilePayload("plan.png", "image/png", plan()));
    page.locator("#import-resolution").fill("0.3");
    page.locator("#import").click();
    assertThat(page.locator("#import-said")).hasText("Imported: 40 × 20 cells.");
    tool(page, "stations");
    click(page, 1.05, 1.05);
    page.locator("#publish").click();
    assertThat(page.locator("#problem-list")).containsText("Station 1 lies in a wall");
    assertThat(page.locator("#publishing")).isHidden();
    page.locator("#problem-list button").click();
    picture(page, "editor-problem");
    tool(page, "select");
    page.locator("#zoom-fit").click();
    drag(page, 1.05, 1.05, 7.05, 3.15);
    assertThat(page.locator("#problems-summary"))
        .hasText("Found in an older draft. Check again to see what is left:");
    page.locator("#check").click();
    assertThat(page.locator("#problems-summary")).hasText("No problems found.");
    page.locator("#undo").click();
    assertThat(page.locator("#problems")).isHidden();
    page.locator("#redo").click();
    page.locator("#publish").click();
    page.locator("#publish-sure").click();
    assertThat(page.locator("#problems-summary")).hasText("Published. The drawing is in force.");
    assertEquals("Station 1", floor("hall").stations().getFirst().name());

    page.locator("#import-file")
        .setInputFiles(new FilePayload("plan.png", "image/png", new byte[9]));
    page.locator("#import").click();
    assertThat(page.locator("#import-said")).containsText("plan.png is not a readable PNG picture");
  }

  @Test
  void aFloorWithoutAMapIsExploredMendedAndPublished() {
    Page page = loggedIn(WebTestServer.MANAGER, DESK, "floors");
    page.locator("#name").fill("Unknown");
    button(page, "Add floor").click();
    click(page.locator("tbody tr").nth(1).getByText("Explore"));
    page.locator("#robots").fill("12");
    page.locator("#startX").fill("6");
    assertFits(page, "exploration-form", PHONE, DESK);
    button(page, "Start exploration").click();
    assertThat(page.locator("#robots-help")).hasText("Enter a whole number from 1 to 9.");
    page.locator("#robots").fill("4");
    button(page, "Start exploration").click();
    assertThat(page.locator("#startX-help")).containsText("There is no room here for 4 robots");

    server.setExplorationSpeed(2);
    page.locator("#startX").fill("2");
    button(page, "Start exploration").click();
    assertThat(page.locator("#exploration .state")).hasText("Exploring");
    Locator driven = page.locator("[data-fact=driven]");
    assertThat(driven).not().hasText("");
    String first = driven.textContent();
    Object before = sceneOf(page);
    assertThat(driven).not().hasText(first); // the page looks by itself
    await(page, () -> !sceneOf(page).equals(before));
    assertFits(page, "exploration-running", PHONE, DESK);
    server.setExplorationSpeed(Double.POSITIVE_INFINITY);
    assertThat(page.locator("#exploration .state")).hasText("Target reached");
    assertThat(page.getByRole(AriaRole.STATUS)).containsText("What was seen is the draft");
    assertFits(page, "exploration", PHONE, DARK, DESK);
    List<String> faults = new ArrayList<>(Accessibility.faults(page, "exploration"));
    page.navigate(server.root() + "language/ar?back=/floors/Unknown/exploration");
    assertThat(page.locator("#exploration .state")).hasText("بلغ الهدف");
    assertFits(page, "exploration-ar", PHONE, DESK);
    faults.addAll(Accessibility.faults(page, "exploration in Arabic"));
    assertEquals(List.of(), faults);
    page.navigate(server.root() + "language/en?back=/floors/Unknown/exploration");

    click(page.getByText("Open it in the editor"));
    assertThat(page.locator("#save-state")).hasText("Draft saved");
    FloorDrawing explored = draft("Unknown").drawing();
    tool(page, "stations");
    OccupancyGrid walls = explored.walls();
    MapCanvas.ofEditor(
            page, walls.width() * walls.resolution(), walls.height() * walls.resolution())
        .click(3.05 - walls.origin().x(), 2.05 - walls.origin().y());
    await(page, () -> draft("Unknown").drawing().stations().size() == 1);
    page.locator("#publish").click();
    page.locator("#publish-sure").click();
    assertThat(page.locator("#problems-summary")).hasText("Published. The drawing is in force.");
    assertEquals(explored.walls(), floor("Unknown").drawing().walls());

    server.setExplorationSpeed(1);
    page.navigate(server.root() + "floors/hall/exploration");
    page.locator("#ground").selectOption("floor:Unknown");
    button(page, "Start exploration").click();
    saveElsewhere(floor("hall").drawing().withStations(List.of()));
    click(page.locator("main").getByText("Stop", exactly()));
    assertThat(page.locator("#exploration .state")).hasText("Stopped");
    assertThat(page.locator("#exploration")).containsText("Somebody has drawn on this floor");
    click(page.getByText("Replace the walls of the draft"));
    assertThat(page.getByRole(AriaRole.STATUS)).containsText("What was seen is the draft");
    awaitDraft(drawing -> drawing.walls().resolution() == 0.1 && drawing.stations().isEmpty());
  }

  private static Object sceneOf(Page page) {
    return page.evaluate("document.querySelector('canvas.exploration').toDataURL()");
  }

  /** Of 40 x 20 cells, the western quarter dark. */
  private static byte[] plan() throws IOException {
    BufferedImage image = new BufferedImage(40, 20, BufferedImage.TYPE_BYTE_GRAY);
    image.createGraphics().fillRect(10, 0, 30, 20);
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    ImageIO.write(image, "png", out);
    return out.toByteArray();
  }

  private Page editor(String user) {
    Page page = loggedIn(user, DESK, "floors/hall/edit");
    assertThat(page.locator("#save-state")).hasText("Nothing changed yet");
    return page;
  }

  private void saveElsewhere(FloorDrawing drawing) {
    server
        .fleet()
        .floorEditing()
        .saveDraft("hall", drawing, draft("hall").revision(), "Ann")
        .toCompletableFuture()
        .join();
  }

  private FloorDraft draft(String floor) {
    return server.fleet().floorEditing().draft(floor).orElseThrow();
  }

  private FloorMap floor(String name) {
    return server.fleet().floors().stream()
        .filter(f -> f.name().equals(name))
        .findFirst()
        .orElseThrow();
  }

  private void awaitDraft(Predicate<FloorDrawing> condition) {
    await(page(), () -> condition.test(draft("hall").drawing()));
  }

  private static void press(Page page, String key, int times) {
    for (int i = 0; i < times; i++) {
      page.keyboard().press(key);
    }
  }

  private static void tool(Page page, String tool) {
    page.locator("[data-tool=" + tool + "]").click();
  }

  private static double[] at(Page page, double x, double y) {
    return canvas(page).at(x, y);
  }

  private static void click(Page page, double x, double y) {
    canvas(page).click(x, y);
  }

  private static void drag(Page page, double fromX, double fromY, double toX, double toY) {
    canvas(page).drag(fromX, fromY, toX, toY);
  }

  /** Of a floor of 12 m x 6 m. */
  private static MapCanvas canvas(Page page) {
    return MapCanvas.ofEditor(page, 12, 6);
  }

  private static void touch(CDPSession session, String type, double[]... fingers) {
    JsonArray points = new JsonArray();
    for (int i = 0; i < fingers.length; i++) {
      JsonObject point = new JsonObject();
      point.addProperty("x", fingers[i][0]);
      point.addProperty("y", fingers[i][1]);
      point.addProperty("id", i);
      points.add(point);
    }
    JsonObject event = new JsonObject();
    event.addProperty("type", type);
    event.add("touchPoints", points);
    session.send("Input.dispatchTouchEvent", event);
  }
}
