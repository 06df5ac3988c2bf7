package org.toqa.agent.firmware;

import java.io.IOException;
import java.nio.file.Path;
import org.toqa.sim.SimulatedMicrocontroller;
import org.toqa.sim.SimulatedMicrocontroller.Board;

/** The hex files, each on the board that it is for. */
public enum FirmwareBuild {
  LM629_AT_16_MHZ("toqa.hex", "lm629", 16_000_000, 5_700),
  PWM_AT_16_MHZ("toqa-pwm.hex", "pwm", 16_000_000, 5_700),
  LM629_AT_8_MHZ("8mhz/toqa.hex", "lm629", 8_000_000, 9_800),
  PWM_AT_8_MHZ("8mhz/toqa-pwm.hex", "pwm", 8_000_000, 9_800);

  private final String hex;
  private final String drive;
  private final int hertz;
  private final long busiestMicros;

  FirmwareBuild(String hex, String drive, int hertz, long busiestMicros) {
    this.hex = hex;
    this.drive = drive;
    this.hertz = hertz;
    this.busiestMicros = busiestMicros;
  }

  /**
   * Switches it on.
   *
   * @param folder of its socket and its EEPROM
   */
  public SimulatedMicrocontroller start(Path folder) throws IOException {
    Path firmware = Path.of("firmware/build").toAbsolutePath();
    return SimulatedMicrocontroller.start(firmware, new Board(hex, drive, hertz), folder);
  }

  boolean isPwm() {
    return drive.equals("pwm");
  }

  /** Of an exchange as fast as {@code docs/spi-frame.md} allows: 256 cycles a byte. */
  int exchangeMicros() {
    return (int) (FrameCodec.LENGTH * 256 * 1_000_000L / hertz);
  }

  /** Of 10,000, the period of the wheels: what its program may take at most while it drives. */
  long busiestMicros() {
    return busiestMicros;
  }
}
