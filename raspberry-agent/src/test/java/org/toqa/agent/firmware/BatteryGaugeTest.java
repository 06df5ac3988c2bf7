package org.toqa.agent.firmware;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class BatteryGaugeTest {
  private final BatteryGauge gauge = new BatteryGauge();

  @Test
  void chargeFollowsTheCurveOfCellsAtRest() {
    assertEquals(1, chargeOf(16.8), 1e-9); // 4 * 4.20 V
    assertEquals(0.5, chargeOf(15.36), 1e-9); // 4 * 3.84 V, where a straight line says 60 %
    assertEquals(0.1, chargeOf(14.76), 1e-9); // 4 * 3.69 V, where a straight line says 43 %
    assertEquals(0, chargeOf(BatteryGauge.EMPTY_VOLTS), 1e-9);
    assertEquals(0, chargeOf(12), 1e-9);
    assertEquals(1, chargeOf(17), 1e-9);
  }

  @Test
  void anEmptierBatteryIsNeverToldFuller() {
    double before = 2;
    for (double volts = 17; volts > 13; volts -= 0.01) {
      double charge = chargeOf(volts);
      assertTrue(charge <= before, "at " + volts + " V");
      before = charge;
    }
  }

  @Test
  void whatWheelsDrawForAMomentIsNoUse() {
    gauge.update(15.36, 0);
    for (int i = 0; i < 100; i++) {
      gauge.update(14.76, 0.01); // a second
    }
    assertTrue(gauge.charge() > 0.45, String.valueOf(gauge.charge()));
    for (int i = 0; i < 100; i++) {
      gauge.update(14.76, 2);
    }
    assertEquals(0.1, gauge.charge(), 0.01);
  }

  @Test
  void whatIsNotMeasuredYetIsNoVoltage() {
    gauge.update(0, 0);
    gauge.update(15.36, 0.01);
    assertEquals(0.5, gauge.charge(), 1e-9);
  }

  private static double chargeOf(double volts) {
    BatteryGauge gauge = new BatteryGauge();
    gauge.update(volts, 0);
    return gauge.charge();
  }
}
