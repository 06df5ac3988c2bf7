package org.toqa.web.page;

import static org.junit.jupiter.api.Assertions.assertTrue;

import com.microsoft.playwright.Locator;
import com.microsoft.playwright.Page;
import com.microsoft.playwright.assertions.PlaywrightAssertions;

/** How somebody uses a page: by nothing but the keyboard, or by a finger on a phone. */
interface Hand {
  /** A button, a link, a box to tick, or what opens. */
  void press(Locator target);

  void write(Locator field, String text);

  /**
   * @param value of the option
   */
  void choose(Locator list, String value);

  /**
   * Keys alone. What is wanted is reached by the Tab key, as a person would reach it, and must show
   * that it has the focus.
   */
  record Keyboard(Page page) implements Hand {
    private static final int MOST_STEPS = 200;

    /** Tabs to it. */
    void reach(Locator target) {
      PlaywrightAssertions.assertThat(target).isVisible();
      for (int i = 0; i < MOST_STEPS; i++) {
        if (isFocused(target)) {
          assertTrue(
              (Boolean) target.evaluate("element => element.matches(':focus-visible')"),
              () -> "it does not show that it has the focus: " + target);
          return;
        }
        page.keyboard().press("Tab");
      }
      throw new AssertionError("no key leads to " + target + " on " + page.url());
    }

    private static boolean isFocused(Locator target) {
      return (Boolean) target.evaluate("element => element === document.activeElement");
    }

    @Override
    public void press(Locator target) {
      reach(target);
      boolean isBox = (Boolean) target.evaluate("element => element.matches('[type=checkbox]')");
      page.keyboard().press(isBox ? "Space" : "Enter");
    }

    @Override
    public void write(Locator field, String text) {
      reach(field);
      boolean isTime = (Boolean) field.evaluate("element => element.type === 'time'");
      if (!isTime) { // which has parts, of which each takes its digits
        page.keyboard().press("Control+a");
      }
      page.keyboard().type(text);
    }

    @Override
    public void choose(Locator list, String value) {
      reach(list);
      page.keyboard().press("Home");
      for (int i = 0; !list.inputValue().equals(value); i++) {
        assertTrue(i < MOST_STEPS, () -> value + " cannot be chosen in " + list);
        page.keyboard().press("ArrowDown");
      }
    }
  }

  /** On a screen that is touched. */
  record Finger() implements Hand {
    @Override
    public void press(Locator target) {
      target.tap();
    }

    @Override
    public void write(Locator field, String text) {
      field.tap();
      field.fill(text);
    }

    @Override
    public void choose(Locator list, String value) {
      list.selectOption(value);
    }
  }
}
