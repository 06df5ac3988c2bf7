package org.toqa.web.page;

import static com.microsoft.playwright.assertions.PlaywrightAssertions.assertThat;

import java.nio.file.Path;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.testbed.BrowserTest;
import org.toqa.testbed.ToqaProcess;

class FirstPageIT extends BrowserTest {
  @TempDir private Path folder;

  @Test
  void aBrowserShowsTheFirstPage() throws Exception {
    try (ToqaProcess server = ToqaProcess.toqa(folder, "server", "--port", "0")) {
      page().navigate(server.awaitErr("http://[^ ]*").group());

      assertThat(page()).hasTitle(Pattern.compile("Toqa"));
    }
  }
}
