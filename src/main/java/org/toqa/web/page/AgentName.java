package org.toqa.web.page;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/**
 * What a browser or program that calls itself so is known as. Browsers call themselves by the names
 * of others too, so the marks of the rarer ones come first (RFC 9110, 10.1.5, and what browsers
 * send).
 *
 * @param program such as Firefox or curl; null: it does not say
 * @param system such as Windows; null: it does not say
 */
public record AgentName(@Nullable String program, @Nullable String system) {
  private static final Map<String, String> BROWSERS = new LinkedHashMap<>();
  private static final Map<String, String> SYSTEMS = new LinkedHashMap<>();

  static {
    BROWSERS.put("Edg", "Edge"); // also EdgA and EdgiOS
    BROWSERS.put("OPR/", "Opera");
    BROWSERS.put("SamsungBrowser/", "Samsung Internet");
    BROWSERS.put("Firefox/", "Firefox");
    BROWSERS.put("FxiOS/", "Firefox");
    BROWSERS.put("CriOS/", "Chrome");
    BROWSERS.put("Chrome/", "Chrome");
    BROWSERS.put("Safari/", "Safari");
    SYSTEMS.put("Android", "Android");
    SYSTEMS.put("iPhone", "iPhone");
    SYSTEMS.put("iPad", "iPad");
    SYSTEMS.put("Windows", "Windows");
    SYSTEMS.put("Mac OS X", "macOS");
    SYSTEMS.put("CrOS", "ChromeOS");
    SYSTEMS.put("Linux", "Linux");
  }

  /** All browsers begin so. */
  private static final String BROWSER = "Mozilla/";

  private static final Pattern PRODUCT = Pattern.compile("[A-Za-z][A-Za-z0-9 ._-]{0,39}");

  public static AgentName of(String agent) {
    if (agent.startsWith(BROWSER)) {
      return new AgentName(first(BROWSERS, agent), first(SYSTEMS, agent));
    }
    Matcher product = PRODUCT.matcher(agent);
    return new AgentName(product.lookingAt() ? product.group().strip() : null, null);
  }

  private static @Nullable String first(Map<String, String> names, String agent) {
    return names.entrySet().stream()
        .filter(name -> agent.contains(name.getKey()))
        .map(Map.Entry::getValue)
        .findFirst()
        .orElse(null);
  }
}
