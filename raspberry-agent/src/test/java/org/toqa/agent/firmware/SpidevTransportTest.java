package org.toqa.agent.firmware;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SpidevTransportTest {

  @ParameterizedTest
  @CsvSource({
    "/dev/no-such-bus, '/dev/no-such-bus cannot be opened; check that SPI is switched on and that this user may use it (errno 2).'",
    "/dev/null, '/dev/null is no SPI device (errno 25).'" // ENOTTY: the call reached the kernel
  })
  void whatIsNoBusIsNamed(Path device, String sentence) {
    IOException refused =
        assertThrows(IOException.class, () -> new SpidevTransport(device, 1_000_000, 16).close());

    assertEquals(sentence, refused.getMessage());
  }
}
