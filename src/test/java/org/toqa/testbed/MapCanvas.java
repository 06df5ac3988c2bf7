package org.toqa.testbed;

import com.microsoft.playwright.Locator;
import com.microsoft.playwright.Mouse;
import com.microsoft.playwright.Page;
import com.microsoft.playwright.options.BoundingBox;

/**
 * A floor drawn on a page, fitted into its canvas: points are of the map frame, in metres.
 *
 * @param page that shows it
 * @param margin left free on both sides together, pixels
 * @param width of the floor, metres
 * @param height of the floor, metres
 */
public record MapCanvas(Page page, double margin, double width, double height) {
  /** As the editor draws it. */
  public static MapCanvas ofEditor(Page page, double width, double height) {
    return new MapCanvas(page, 34, width, height);
  }

  /** As the live map and the form of a task draw it. */
  public static MapCanvas ofMap(Page page, double width, double height) {
    return new MapCanvas(page, 32, width, height);
  }

  public void click(double x, double y) {
    double[] point = at(x, y);
    page.mouse().click(point[0], point[1]);
  }

  public void drag(double fromX, double fromY, double toX, double toY) {
    double[] from = at(fromX, fromY);
    double[] to = at(toX, toY);
    page.mouse().move(from[0], from[1]);
    page.mouse().down();
    page.mouse().move(to[0], to[1], new Mouse.MoveOptions().setSteps(3));
    page.mouse().up();
  }

  /** Where the point is on the page, pixels. */
  public double[] at(double x, double y) {
    page.waitForFunction("() => document.querySelector('#map').width > 300");
    Locator map = page.locator("#map");
    map.scrollIntoViewIfNeeded();
    BoundingBox box = map.boundingBox();
    double scale = Math.min((box.width - margin) / width, (box.height - margin) / height);
    return new double[] {
      box.x + box.width / 2 + (x - width / 2) * scale,
      box.y + box.height / 2 - (y - height / 2) * scale
    };
  }
}
