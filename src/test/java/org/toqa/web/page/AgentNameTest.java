package org.toqa.web.page;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class AgentNameTest {

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      nullValues = "-",
      value = {
        "Mozilla/5.0 (X11; Linux x86_64) AppleWebKit/537.36 (KHTML, like Gecko) Chrome/143.0.0.0"
            + " Safari/537.36|Chrome|Linux",
        "Mozilla/5.0 (Windows NT 10.0; Win64; x64) AppleWebKit/537.36 (KHTML, like Gecko)"
            + " Chrome/143.0.0.0 Safari/537.36 Edg/143.0.0.0|Edge|Windows",
        "Mozilla/5.0 (Windows NT 10.0; Win64; x64; rv:145.0) Gecko/20100101"
            + " Firefox/145.0|Firefox|Windows",
        "Mozilla/5.0 (Macintosh; Intel Mac OS X 10_15_7) AppleWebKit/605.1.15 (KHTML, like Gecko)"
            + " Version/18.6 Safari/605.1.15|Safari|macOS",
        "Mozilla/5.0 (iPhone; CPU iPhone OS 18_6 like Mac OS X) AppleWebKit/605.1.15 (KHTML, like"
            + " Gecko) CriOS/143.0 Mobile/15E148 Safari/604.1|Chrome|iPhone",
        "Mozilla/5.0 (Linux; Android 16) AppleWebKit/537.36 (KHTML, like Gecko)"
            + " SamsungBrowser/29.0 Chrome/136.0.0.0 Mobile Safari/537.36|Samsung Internet|Android",
        "curl/8.14.1|curl|-",
        "python-requests/2.32|python-requests|-",
        "Node-RED|Node-RED|-",
        "Mozilla/5.0|-|-",
        "''|-|-",
        "<script>|-|-"
      })
  void programsAreKnownByTheirNames(String agent, String program, String system) {
    assertEquals(new AgentName(program, system), AgentName.of(agent));
  }
}
