package org.toqa.web.page;

import com.deque.html.axecore.args.AxeRunOptions;
import com.deque.html.axecore.playwright.AxeBuilder;
import com.deque.html.axecore.results.AxeResults;
import com.deque.html.axecore.results.CheckedNode;
import com.deque.html.axecore.results.Rule;
import com.microsoft.playwright.Page;
import java.util.ArrayList;
import java.util.List;
import org.toqa.testbed.Tally;

/** The rules of WCAG 2.2, levels A and AA, that axe can check. */
final class Accessibility {
  private static final List<String> RULES =
      List.of("wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa");

  /** Those of them that look at colours. */
  private static final List<String> COLOUR_RULES = List.of("color-contrast", "link-in-text-block");

  private Accessibility() {}

  /** What is in somebody's way on the page, a sentence each, which begins with its name. */
  static List<String> faults(Page page, String name) {
    return faults(axe(page).withTags(RULES), name);
  }

  /**
   * The same by the rules of colours, for a page that was looked at by all of them and of which
   * nothing but the colours has changed.
   */
  static List<String> faultsOfColours(Page page, String name) {
    return faults(axe(page).withRules(COLOUR_RULES), name);
  }

  /**
   * When no colour changes any more. No page has frames: none is to be opened to put their results
   * together.
   */
  private static AxeBuilder axe(Page page) {
    page.evaluate(
        """
        () => document.getAnimations()
            .filter((animation) => animation.effect.getComputedTiming().endTime < Infinity)
            .forEach((animation) => animation.finish())
        """);
    AxeRunOptions options = new AxeRunOptions();
    options.setResultTypes(List.of("violations", "incomplete")); // of what passes no nodes
    return new AxeBuilder(page).options(options).setLegacyMode(true);
  }

  private static List<String> faults(AxeBuilder axe, String name) {
    Tally.add("looks at pages by axe", 1);
    List<String> found = new ArrayList<>();
    AxeResults results = axe.analyze();
    for (Rule rule : results.getViolations()) {
      rule.getNodes().forEach(node -> found.add(sentence(name, rule, node)));
    }
    for (Rule rule : results.getIncomplete()) {
      rule.getNodes().stream()
          .filter(Accessibility::isOfTheColourOfItsGround)
          .forEach(node -> found.add(sentence(name, rule, node)));
    }
    return found;
  }

  /** Of such text axe says only that it does not know whether it shall be seen. */
  private static boolean isOfTheColourOfItsGround(CheckedNode node) {
    return node.getAny().stream()
        .anyMatch(check -> String.valueOf(check.getData()).contains("equalRatio"));
  }

  private static String sentence(String name, Rule rule, CheckedNode node) {
    return name + ": " + rule.getId() + " " + node.getHtml() + " " + rule.getHelp();
  }
}
