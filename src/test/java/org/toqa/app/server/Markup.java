package org.toqa.app.server;

import static org.junit.jupiter.api.Assertions.assertFalse;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A page as a browser reads it: its elements with their attributes, and its text. Reads what HTML
 * says of tags, comments, raw text and the character references that the views write.
 */
final class Markup {
  private static final Pattern TOKEN =
      Pattern.compile(
          "<!--.*?-->|<!doctype[^>]*>|</([a-zA-Z][^\\s/>]*)[^>]*>"
              + "|<([a-zA-Z][^\\s/>]*)((?:[^>\"']|\"[^\"]*\"|'[^']*')*)>",
          Pattern.DOTALL | Pattern.CASE_INSENSITIVE);
  private static final Pattern ATTRIBUTE =
      Pattern.compile("([^\\s\"'>/=]+)(?:\\s*=\\s*(?:\"([^\"]*)\"|'([^']*)'|([^\\s\"'>]+)))?");
  private static final Pattern REFERENCE = Pattern.compile("&(#\\d+|lt|gt|amp|quot|nbsp);");

  private final List<Element> elements = new ArrayList<>();
  private final StringBuilder text = new StringBuilder();

  /** A start tag. */
  record Element(String name, Map<String, String> attributes, int textBefore) {
    String attribute(String name) {
      return attributes.getOrDefault(name, "");
    }

    boolean has(String name) {
      return attributes.containsKey(name);
    }
  }

  private Markup() {}

  static Markup read(String page) {
    Markup markup = new Markup();
    Matcher token = TOKEN.matcher(page);
    int end = 0;
    while (token.find(end)) {
      markup.text.append(decoded(page.substring(end, token.start())));
      end = token.end();
      if (token.group(1) != null) {
        markup.add("/" + token.group(1), "");
      } else if (token.group(2) != null) {
        markup.add(token.group(2), token.group(3));
        if (token.group(2).equalsIgnoreCase("script")) {
          end = endOfScript(page, end);
        }
      }
    }
    markup.text.append(decoded(page.substring(end)));
    return markup;
  }

  private static int endOfScript(String page, int from) {
    int end = page.toLowerCase(Locale.ROOT).indexOf("</script", from);
    assertFalse(
        page.substring(from, end).contains(Attack.MARK), "A script has what somebody typed.");
    return end;
  }

  private void add(String name, String attributes) {
    Map<String, String> found = new LinkedHashMap<>();
    Matcher attribute = ATTRIBUTE.matcher(attributes);
    while (attribute.find()) {
      String value = "";
      for (int group = 2; group <= 4; group++) {
        value = attribute.group(group) == null ? value : attribute.group(group);
      }
      found.put(attribute.group(1).toLowerCase(Locale.ROOT), decoded(value));
    }
    elements.add(new Element(name.toLowerCase(Locale.ROOT), found, text.length()));
  }

  private static String decoded(String text) {
    return REFERENCE
        .matcher(text)
        .replaceAll(
            reference ->
                Matcher.quoteReplacement(
                    switch (reference.group(1)) {
                      case "lt" -> "<";
                      case "gt" -> ">";
                      case "amp" -> "&";
                      case "quot" -> "\"";
                      case "nbsp" -> "\u00a0";
                      default ->
                          Character.toString(Integer.parseInt(reference.group(1).substring(1)));
                    }));
  }

  List<Element> elements() {
    return elements;
  }

  /** What a person reads. */
  String text() {
    return text.toString();
  }

  /** Nothing that an attacker typed has become a part of the page itself. */
  void assertHarmless(String where) {
    for (Element element : elements) {
      assertFalse(element.name().contains(Attack.MARK), where + " has an element " + element);
      element
          .attributes()
          .forEach(
              (name, value) -> {
                boolean isAddress = List.of("href", "src", "action").contains(name);
                String start = value.strip().toLowerCase(Locale.ROOT);
                assertFalse(
                    name.contains(Attack.MARK)
                        || (name.startsWith("on") && name.length() > 2)
                        || isAddress
                            && (start.startsWith("javascript:")
                                || start.startsWith("//")
                                || start.startsWith("data:")),
                    where + " has an attribute of an attacker: " + element);
              });
    }
    assertFalse(text().contains(Attack.EVALUATED), where + " evaluates what was typed");
    assertFalse(text().contains("Exception"), where + " shows a stack trace");
    assertFalse(text().contains("root:x:"), where + " shows a file");
  }
}
