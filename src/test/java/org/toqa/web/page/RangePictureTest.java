package org.toqa.web.page;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;

class RangePictureTest {
  @Test
  void sectorsAreFromRightToLeftAndAsLongAsTheRange() {
    List<RangePicture.Sector> sectors = RangePicture.of(List.of(0.4, 0.8), 0.8);

    assertEquals(
        new RangePicture.Sector(
            "M12.9,-15.3 L38.6,-46.0 A60.0 60.0 0 0 0 -0.0,-60.0 L-0.0,-20.0 A20 20 0 0 1 12.9,-15.3 Z",
            true),
        sectors.get(0));
    assertEquals(false, sectors.get(1).isBlocked());
  }
}
