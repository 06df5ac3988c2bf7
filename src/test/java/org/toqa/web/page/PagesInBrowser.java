package org.toqa.web.page;

import static com.microsoft.playwright.assertions.PlaywrightAssertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import com.microsoft.playwright.Browser;
import com.microsoft.playwright.Locator;
import com.microsoft.playwright.Page;
import com.microsoft.playwright.options.AriaRole;
import com.microsoft.playwright.options.ColorScheme;
import com.microsoft.playwright.options.Cookie;
import com.microsoft.playwright.options.ScreenshotAnimations;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.toqa.fleet.RobotChange;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.RobotView.Work;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.mission.Phase;
import org.toqa.testbed.BrowserTest;
import org.toqa.testbed.Hall;
import org.toqa.traffic.floor.PathDeviation;
import org.toqa.traffic.floor.RemainingPath;
import org.toqa.web.TestClient;
import org.toqa.web.WebTestServer;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * One server for the class, on which nothing has happened when a test begins, a browser, and what
 * its tests look at; scripts must not complain.
 */
abstract class PagesInBrowser extends BrowserTest {
  static final Screen DESK = new Screen(1280, 900, ColorScheme.LIGHT, "desktop");
  static final Screen DARK = new Screen(1280, 900, ColorScheme.DARK, "dark");
  static final Screen PHONE = new Screen(390, 844, ColorScheme.LIGHT, "phone");
  static final Screen DARK_PHONE = new Screen(390, 844, ColorScheme.DARK, "phone-dark");

  private static final Path PICTURES = Path.of("target/screenshots");

  WebTestServer server;

  /** Of those who have logged in, by their names. */
  private final Map<String, List<Cookie>> sessions = new TreeMap<>();

  record Screen(int width, int height, ColorScheme scheme, String name) {
    /** The page is at once as it would be there from the beginning. */
    void show(Page page) {
      page.setViewportSize(width, height);
      page.emulateMedia(new Page.EmulateMediaOptions().setColorScheme(scheme));
    }
  }

  @BeforeAll
  final void start() throws Exception {
    server = startServer();
  }

  WebTestServer startServer() throws Exception {
    return WebTestServer.startForBrowser();
  }

  @BeforeEach
  final void begin() {
    server.forgetWork();
    server.fleet().changeRobots(none -> robots());
  }

  /** The fleet when a test begins. */
  List<RobotView> robots() {
    return fleetAtWork();
  }

  @AfterEach
  final void nothingIsComplainedOf() {
    assertEquals(
        List.of(),
        complaints().stream().filter(c -> !c.startsWith("Failed to load resource")).toList());
  }

  @AfterAll
  final void stop() throws Exception {
    server.close();
  }

  static void assertFits(Page page) {
    assertFalse(
        (Boolean)
            page.evaluate("document.documentElement.scrollWidth > innerWidth || scrollX !== 0"),
        () -> page.url() + " is wider than the screen");
  }

  /** On each screen the page fits; a picture of it is taken where they are wanted. */
  static void assertFits(Page page, String name, Screen... screens) {
    for (Screen screen : screens) {
      screen.show(page);
      picture(page, screen.name() + "-" + name);
      awaitFrame(page);
      assertFits(page);
    }
  }

  /** Clicks on the screen of a desk, after it has been seen that a phone's could be clicked too. */
  static void click(Locator locator) {
    PHONE.show(locator.page());
    locator.click(new Locator.ClickOptions().setTrial(true));
    DESK.show(locator.page());
    locator.click();
  }

  static Page.GetByRoleOptions link(String name) {
    return new Page.GetByRoleOptions().setName(name).setExact(true);
  }

  static Locator button(Page page, String name) {
    return page.getByRole(AriaRole.BUTTON, link(name));
  }

  static Locator.GetByTextOptions exactly() {
    return new Locator.GetByTextOptions().setExact(true);
  }

  Page loggedIn(int width, int height, ColorScheme scheme) {
    return loggedIn(WebTestServer.MANAGER, new Screen(width, height, scheme, ""), "map");
  }

  /** A page of a user, at an address; only the first one of a class logs in by the form. */
  Page loggedIn(String user, Screen screen, String path) {
    return loggedIn(
        user,
        new Browser.NewContextOptions()
            .setViewportSize(screen.width(), screen.height())
            .setColorScheme(screen.scheme()),
        path);
  }

  Page loggedIn(String user, Browser.NewContextOptions options, String path) {
    Page page = openPage(options.setTimezoneId("America/Bogota"));
    List<Cookie> session = sessions.get(user);
    if (session == null) {
      page.navigate(server.root().toString());
      logIn(page, user);
      sessions.put(user, page.context().cookies());
      if (path.equals("map")) {
        return page;
      }
    } else {
      page.context().addCookies(session);
    }
    page.navigate(server.root() + path);
    if (path.equals("map")) {
      assertThat(page.locator("#map")).isVisible();
    }
    return page;
  }

  /**
   * Somebody's day: a page that is used by one hand, in a language.
   *
   * @param film null: it is not filmed
   */
  record Day(Page page, Hand hand, @Nullable Film film) {
    Locator the(String selector) {
      return page.locator(selector).first();
    }

    /** At what comes next, which is there then; a page that is just loaded may move the focus. */
    private void look(Locator next) {
      page.waitForLoadState();
      assertThat(next).isVisible();
      if (film != null) {
        film.take(page);
      }
    }

    void press(String selector) {
      look(the(selector));
      hand.press(the(selector));
    }

    void write(String selector, String text) {
      hand.write(the(selector), text);
    }

    void choose(String selector, String value) {
      hand.choose(the(selector), value);
    }

    /** By the navigation, where what is seldom wanted is in a menu. */
    void go(String path) {
      Locator entry = the(".top nav a[href$='/" + path + "']:visible");
      if (entry.count() == 0) {
        press(".more summary");
      }
      look(entry);
      hand.press(entry);
      page.waitForURL("**/" + path);
    }

    /** And goes home. */
    void logOut() {
      press(".top form[action$='/logout'] button");
      look(the("#password"));
      if (film != null) {
        film.close();
      }
    }
  }

  /**
   * A day begins with the login, at a desk by the keyboard alone, or on a phone by touch. In a
   * whole walk {@code target/film} has its film.
   */
  Day dayOf(String user, String language, boolean byKeyboard) {
    Browser.NewContextOptions options = new Browser.NewContextOptions().setTimezoneId("UTC");
    Screen screen = byKeyboard ? DESK : PHONE;
    Page page =
        openPage(options.setViewportSize(screen.width(), screen.height()).setHasTouch(!byKeyboard));
    Day day =
        new Day(
            page,
            byKeyboard ? new Hand.Keyboard(page) : new Hand.Finger(),
            IS_WHOLE_WALK ? new Film("day-" + user + "-" + language) : null);
    page.navigate(server.root() + "language/" + language);
    day.write("#name", user);
    day.write("#password", WebTestServer.PASSWORD);
    day.press("main form button");
    assertThat(page.locator("#map")).isVisible();
    return day;
  }

  /** By the form, in whatever language. */
  static void logIn(Page page, String user) {
    page.locator("#name").fill(user);
    page.locator("#password").fill(WebTestServer.PASSWORD);
    page.locator("main button").click();
    assertThat(page.locator("#map")).isVisible();
  }

  /** All users, also those of this class, must log in again. */
  void endSessions() {
    server.endSessions();
    sessions.clear();
  }

  /**
   * Clicks where the floor of 12 m x 6 m, fitted into the canvas with its margin, has the point.
   */
  static void clickMap(Page page, Locator map, double x, double y) {
    await(page, "document.querySelector('#map').width > 300");
    double width = map.boundingBox().width;
    double height = map.boundingBox().height;
    double scale = Math.min((width - 32) / 12, (height - 32) / 6);
    map.click(
        new Locator.ClickOptions()
            .setPosition(width / 2 + (x - 6) * scale, height / 2 - (y - 3) * scale));
  }

  /** A number that is another one where the map is drawn in any other way. */
  static Object pictureOf(Page page) {
    return page.evaluate(
        """
        () => {
          const map = document.querySelector('#map');
          const {data} = map.getContext('2d').getImageData(0, 0, map.width, map.height);
          return new Uint32Array(data.buffer)
              .reduce((hash, pixel) => Math.imul(hash ^ pixel, 0x01000193), map.width);
        }
        """);
  }

  /** Scripts have drawn for the screen that is shown now. */
  private static void awaitFrame(Page page) {
    page.evaluate(
        "() => new Promise(shown =>"
            + " requestAnimationFrame(() => requestAnimationFrame(() => shown())))");
  }

  /**
   * Takes a picture for people to look at, on a whole walk; the page must be the one that it is to
   * show, since Chromium refuses to take one while another page replaces it.
   */
  static void picture(Page page, String name) {
    page.waitForLoadState();
    if (!IS_WHOLE_WALK) {
      return;
    }
    awaitFrame(page); // colours begin to change then
    page.screenshot(
        new Page.ScreenshotOptions()
            .setAnimations(ScreenshotAnimations.DISABLED)
            .setPath(PICTURES.resolve(name + ".png")));
  }

  static List<RobotView> fleetAtWork() {
    return List.of(
        driving("r1", new Pose(4.2, 4.6, 0.3), 2),
        robot("r2", RobotState.IDLE, new Pose(2.25, 0.75, Math.PI / 2)),
        robot("r3", RobotState.HOLDING, new Pose(7.4, 2.8, Math.PI)),
        robot("r4", RobotState.NOT_LOCALISED, new Pose(10.2, 3.6, -1)),
        robot("r5", RobotState.ERROR, new Pose(8.8, 4.6, 2.3)),
        robot("r6", RobotState.LOST, new Pose(3.4, 2.2, 0)));
  }

  static RobotView driving(String name, Pose pose, long task) {
    return robot(name, RobotState.DRIVING, pose)
        .withWork(new Work(task, Phase.TO_GOAL, false, null, Phrase.CARRIES_LOAD.with(task)))
        .withPath(
            new RemainingPath(
                List.of(
                    new Vec2(5.4, 4.6), new Vec2(6.15, 3.15), new Vec2(8, 3.1), new Vec2(9, 1.05)),
                2,
                new PathDeviation(0.012, -0.03)));
  }

  static RobotView troubled(RobotView still, List<Fault> errors, @Nullable String alert) {
    return still
        .withTelemetry(still.telemetry().withErrors(errors))
        .withAlert(alert == null ? null : Sentence.verbatim(alert));
  }

  static RobotView robot(String name, RobotState state, Pose pose) {
    RobotView still = Hall.robot(name, state, pose, "127.0.0.1", 7275);
    return state == RobotState.ERROR ? withEmptyBattery(still) : still;
  }

  private static RobotView withEmptyBattery(RobotView robot) {
    Fault fault = new Fault("BATTERY_LOW", "The battery is nearly empty.");
    return robot
        .withRecord(robot.record().withChange(new RobotChange("127.0.0.1", 7275, 5, "P3")))
        .withTelemetry(robot.telemetry().withBattery(0.12).withErrors(List.of(fault)))
        .withWork(new Work(null, Phase.NONE, false, null, Phrase.HAS_FAULT.with(fault.text())));
  }

  /** One of each kind. */
  static void addSchedules(TestClient visitor) {
    Map<String, String> task =
        Map.of(
            "name", "Morning tour",
            "load", "2.5",
            "startStation", "Dock A",
            "goalStation", "Shelf 3",
            "zone", "Europe/Paris");
    for (Map<String, String> times :
        List.of(
            Map.of("when", "once", "first", "2098-07-01T15:00"),
            Map.of("when", "every", "first", "2098-07-01T15:00", "everyMinutes", "30"),
            Map.of("when", "weekly", "weekday", "MONDAY", "time", "08:00"))) {
      Map<String, String> form = new TreeMap<>(task);
      form.putAll(times);
      visitor.post("tasks/new", form);
    }
  }
}
