package org.toqa.app.server;

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
  private final StringBuilder scripts = new StringBuilder();

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
          end = markup.endOfScript(page, end);
        }
      }
    }
    markup.text.append(decoded(page.substring(end)));
    return markup;
  }

  /** Scripts are files of their own; what stands in the page itself is nobody's who wrote it. */
  private int endOfScript(String page, int from) {
    int end = page.toLowerCase(Locale.ROOT).indexOf("</script", from);
    scripts.append(page.substring(from, end < 0 ? page.length() : end).strip());
    return end < 0 ? page.length() : end;
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

  /** What an attacker typed that has become a part of the page itself. */
  List<String> faults() {
    List<String> faults = new ArrayList<>();
    for (Element element : elements) {
      if (element.name().contains(Attack.MARK)) {
        faults.add(" has an element of an attacker: " + element);
      }
      element
          .attributes()
          .forEach(
              (name, value) -> {
                boolean isAddress = List.of("href", "src", "action").contains(name);
                String start = value.strip().toLowerCase(Locale.ROOT);
                if (name.contains(Attack.MARK)
                    || (name.startsWith("on") && name.length() > 2)
                    || (isAddress
                        && (start.startsWith("javascript:")
                            || start.startsWith("//")
                            || start.startsWith("data:")))) {
                  faults.add(" has an attribute of an attacker: " + element);
                }
              });
    }
    if (!scripts.isEmpty()) {
      faults.add(" has a script in it: " + scripts);
    }
    return faults;
  }
}
