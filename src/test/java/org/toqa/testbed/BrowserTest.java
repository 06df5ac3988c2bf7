package org.toqa.testbed;

import static java.util.Objects.requireNonNull;

import com.microsoft.playwright.Browser;
import com.microsoft.playwright.Browser.NewContextOptions;
import com.microsoft.playwright.BrowserContext;
import com.microsoft.playwright.BrowserType.LaunchOptions;
import com.microsoft.playwright.Page;
import com.microsoft.playwright.Playwright;
import com.microsoft.playwright.Playwright.CreateOptions;
import com.microsoft.playwright.assertions.PlaywrightAssertions;
import com.microsoft.playwright.options.ReducedMotion;
import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.BooleanSupplier;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.extension.ExtendWith;

/**
 * A test in a headless Chromium, with a fresh profile for each test method. One browser serves all
 * classes of a process.
 */
@Tag("full")
@ExtendWith(SteadyNetwork.class)
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
public abstract class BrowserTest {
  /**
   * {@code -Dtoqa.walk=whole}: with pictures and films, by which nothing is decided, and with the
   * same looks at each page in each language.
   */
  public static final boolean IS_WHOLE_WALK = "whole".equals(System.getProperty("toqa.walk"));

  /** Ends a test that would wait for ever; no machine that works is so slow. */
  private static final int PATIENCE_MS = 60_000;

  private static final int BETWEEN_LOOKS_MS = 30;

  /** The first, of Debian, is Chromium without a desktop, which works less. */
  private static final List<String> NAMES =
      List.of("chromium-headless-shell", "chromium", "chromium-browser", "google-chrome");

  /** Fewer processes: all that a page needs in one, and none besides that would draw. */
  private static final List<String> OPTIONS =
      List.of("--disable-gpu", "--in-process-gpu", "--disable-site-isolation-trials");

  private static @Nullable Browser browser;

  private final List<BrowserContext> profiles = new ArrayList<>();
  private @Nullable Page page;
  private final List<String> complaints = new ArrayList<>();

  /** The page of a test that needs but one: the first that it opened. */
  protected final Page page() {
    if (page == null) {
      return openPage(new NewContextOptions());
    }
    return page;
  }

  /** A page in a profile of its own, which is closed after the test. */
  protected final Page openPage(NewContextOptions options) {
    BrowserContext profile =
        requireNonNull(browser).newContext(options.setReducedMotion(ReducedMotion.REDUCE));
    profiles.add(profile);
    Page opened = profile.newPage();
    page = page == null ? opened : page;
    opened.setDefaultTimeout(PATIENCE_MS);
    opened.onPageError(complaints::add);
    opened.onConsoleMessage(
        message -> {
          if (message.type().equals("error")) {
            complaints.add(message.text());
          }
        });
    return opened;
  }

  /**
   * Waits until an expression is true in the page. It is evaluated from here each time: the policy
   * of our pages forbids that they do it by themselves, as by Playwright's waiting.
   */
  protected static void await(Page page, String expression) {
    await(page, () -> Boolean.TRUE.equals(page.evaluate(expression)));
  }

  /** Waits until what is asked of the page is so, and leaves it time to work between two looks. */
  public static void await(Page page, BooleanSupplier condition) {
    page.waitForCondition(
        () -> {
          if (condition.getAsBoolean()) {
            return true;
          }
          page.waitForTimeout(BETWEEN_LOOKS_MS);
          return false;
        });
  }

  /** Errors on the page's console, and of its scripts. */
  protected final List<String> complaints() {
    return complaints;
  }

  @BeforeAll
  static void openBrowser() {
    PlaywrightAssertions.setDefaultAssertionTimeout(PATIENCE_MS);
    if (browser == null || !browser.isConnected()) {
      browser = startBrowser();
    }
  }

  private static Browser startBrowser() {
    Map<String, String> environment = Map.of("PLAYWRIGHT_SKIP_BROWSER_DOWNLOAD", "1");
    Playwright playwright = Playwright.create(new CreateOptions().setEnv(environment));
    Runtime.getRuntime().addShutdownHook(new Thread(playwright::close));
    return playwright
        .chromium()
        .launch(
            new LaunchOptions()
                .setExecutablePath(chromium())
                // As root, Chromium refuses to run in its sandbox.
                .setChromiumSandbox(!System.getProperty("user.name").equals("root"))
                .setArgs(OPTIONS));
  }

  @BeforeEach
  final void forgetComplaints() {
    complaints.clear();
  }

  @AfterEach
  final void closePages() {
    profiles.forEach(BrowserContext::close);
    profiles.clear();
    page = null;
  }

  private static Path chromium() {
    String path = System.getenv().getOrDefault("PATH", "");
    return Pattern.compile(Pattern.quote(File.pathSeparator))
        .splitAsStream(path)
        .flatMap(folder -> NAMES.stream().map(name -> Path.of(folder, name)))
        .filter(Files::isExecutable)
        .findFirst()
        .orElseThrow(() -> new AssertionError("Chromium is missing: run ./toqa test"));
  }
}
