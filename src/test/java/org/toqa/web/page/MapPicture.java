package org.toqa.web.page;

import com.microsoft.playwright.Locator;
import com.microsoft.playwright.Page;
import com.microsoft.playwright.TimeoutError;
import com.microsoft.playwright.options.BoundingBox;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.function.Predicate;
import javax.imageio.ImageIO;
import org.jspecify.annotations.Nullable;
import org.toqa.testbed.BrowserTest;

/** The map as somebody sees it who looks at the screen, and where a load is seen on it. */
final class MapPicture {
  /** Of the style sheet's --map-load, bright and dark: nothing else has it. */
  private static final int LOAD = 0xe0a030;

  private static final int ALIKE = 8; // of 255
  private static final double NEAR = 2.5; // pixels

  private final Page page;
  private final Locator map;

  MapPicture(Page page) {
    this.page = page;
    map = page.locator("#map");
    BrowserTest.await(
        page,
        () -> ((Number) page.evaluate("document.querySelector('#map').width")).intValue() > 300);
  }

  /** What has the colour of loads: its middle and its size, pixels of the canvas. */
  record Seen(double x, double y, double width, double height) {
    private boolean isNear(Seen other) {
      return Math.abs(x - other.x) <= NEAR
          && Math.abs(y - other.y) <= NEAR
          && Math.abs(width - other.width) <= NEAR
          && Math.abs(height - other.height) <= NEAR;
    }

    Seen movedBy(double dx, double dy) {
      return new Seen(x + dx, y + dy, width, height);
    }

    /** The point of the canvas stays where it is. */
    Seen magnified(double factor, double atX, double atY) {
      return new Seen(
          atX + (x - atX) * factor, atY + (y - atY) * factor, width * factor, height * factor);
    }
  }

  BoundingBox box() {
    return map.boundingBox();
  }

  /** Pixels a metre while the whole floor of 12 m x 6 m is shown. */
  double scale() {
    BoundingBox box = box();
    return Math.min((box.width - 32) / 12, (box.height - 32) / 6);
  }

  /** Where a box of the floor is while the whole floor is shown; metres. */
  Seen whole(double x, double y, double width, double height) {
    double scale = scale();
    return new Seen(
        box().width / 2 + (x - 6) * scale,
        box().height / 2 - (y - 3) * scale,
        width * scale,
        height * scale);
  }

  /** Null where nothing has the colour of loads. */
  @Nullable Seen load() {
    BufferedImage picture = picture();
    int left = Integer.MAX_VALUE;
    int top = Integer.MAX_VALUE;
    int right = -1;
    int bottom = -1;
    for (int y = 0; y < picture.getHeight(); y++) {
      for (int x = 0; x < picture.getWidth(); x++) {
        if (isLoad(picture.getRGB(x, y))) {
          left = Math.min(left, x);
          right = Math.max(right, x);
          top = Math.min(top, y);
          bottom = Math.max(bottom, y);
        }
      }
    }
    // The line around it covers half of its width on each side.
    return right < 0
        ? null
        : new Seen(
            (left + right + 1) / 2.0,
            (top + bottom + 1) / 2.0,
            right - left + 2.5,
            bottom - top + 2.5);
  }

  /** Waits until the load is seen there. */
  void awaitLoad(Seen there) {
    await(seen -> seen != null && seen.isNear(there), there.toString());
  }

  void awaitNoLoad() {
    await(seen -> seen == null, "no load");
  }

  private void await(Predicate<@Nullable Seen> condition, String what) {
    try {
      BrowserTest.await(page, () -> condition.test(load()));
    } catch (TimeoutError e) {
      throw new AssertionError("not seen: " + what + ", but: " + load(), e);
    }
  }

  private BufferedImage picture() {
    try {
      return ImageIO.read(new ByteArrayInputStream(map.screenshot()));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static boolean isLoad(int colour) {
    for (int shift : new int[] {0, 8, 16}) {
      if (Math.abs(((colour >> shift) & 0xff) - ((LOAD >> shift) & 0xff)) > ALIKE) {
        return false;
      }
    }
    return true;
  }
}
