package org.toqa.testbed;

import static java.util.Objects.requireNonNull;

import com.microsoft.playwright.Browser;
import com.microsoft.playwright.BrowserContext;
import com.microsoft.playwright.BrowserType.LaunchOptions;
import com.microsoft.playwright.Page;
import com.microsoft.playwright.Playwright;
import com.microsoft.playwright.Playwright.CreateOptions;
import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.TestInstance;

/** A test in a headless Chromium, with a fresh profile for each test method. */
@Tag("full")
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
public abstract class BrowserTest {
  private static final List<String> NAMES =
      List.of("chromium", "chromium-browser", "google-chrome");

  private @Nullable Playwright playwright;
  private @Nullable Browser browser;
  private @Nullable BrowserContext profile;
  private @Nullable Page page;
  private final List<String> complaints = new ArrayList<>();

  /** The one open page. */
  protected final Page page() {
    return requireNonNull(page);
  }

  /** Errors on the page's console, and of its scripts. */
  protected final List<String> complaints() {
    return complaints;
  }

  @BeforeAll
  final void openBrowser() {
    Map<String, String> environment = Map.of("PLAYWRIGHT_SKIP_BROWSER_DOWNLOAD", "1");
    playwright = Playwright.create(new CreateOptions().setEnv(environment));
    browser =
        playwright
            .chromium()
            .launch(
                new LaunchOptions()
                    .setExecutablePath(chromium())
                    // As root, Chromium refuses to run in its sandbox.
                    .setChromiumSandbox(!System.getProperty("user.name").equals("root"))
                    .setArgs(List.of("--disable-gpu")));
  }

  @BeforeEach
  final void openPage() {
    profile = requireNonNull(browser).newContext();
    page = profile.newPage();
    complaints.clear();
    page.onPageError(complaints::add);
    page.onConsoleMessage(
        message -> {
          if (message.type().equals("error")) {
            complaints.add(message.text());
          }
        });
  }

  @AfterEach
  final void closePage() {
    if (profile != null) {
      profile.close();
    }
  }

  @AfterAll
  final void closeBrowser() {
    if (playwright != null) {
      playwright.close();
    }
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
