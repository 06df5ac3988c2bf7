package org.toqa.app.server;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.toqa.app.server.Markup.Element;

/**
 * A form of a page, as a browser would send it.
 *
 * @param action where it is sent
 * @param fields the values that the page has given them
 */
record PageForm(String method, String action, Map<String, String> fields) {
  private static final Set<String> CONTROLS = Set.of("input", "select", "textarea", "button");

  /** All forms of a page; a field that nobody has named is not sent. */
  static List<PageForm> in(Markup page) {
    List<PageForm> forms = new ArrayList<>();
    String select = "";
    boolean isInForm = false;
    for (Element element : page.elements()) {
      switch (element.name()) {
        case "form" -> {
          forms.add(
              new PageForm(
                  element.has("method") ? element.attribute("method") : "get",
                  element.attribute("action"),
                  new LinkedHashMap<>()));
          isInForm = true;
        }
        case "/form" -> isInForm = false;
        case "option" -> {
          if (isInForm && element.has("selected")) {
            forms.getLast().fields().put(select, element.attribute("value"));
          }
        }
        default -> {
          if (isInForm && CONTROLS.contains(element.name()) && element.has("name")) {
            select = element.attribute("name");
            forms.getLast().fields().putIfAbsent(select, initialValue(element));
          }
        }
      }
    }
    return forms;
  }

  private static String initialValue(Element control) {
    boolean isChoice =
        List.of("checkbox", "radio").contains(control.attribute("type"))
            || control.name().equals("button");
    return isChoice ? "" : control.attribute("value");
  }
}
