package org.toqa.agent;

import java.nio.file.Path;
import java.time.Duration;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.motion.Segment;

/** A daemon over a simulated body, with a server that is connected to it. */
abstract class ConnectedRobotTest {
  /** One metre straight on in four seconds. */
  static final Segment METRE = new Segment(0.25, 0, 4);

  static final Duration MINUTE = Duration.ofMinutes(1);

  @TempDir Path folder;
  Rig rig;
  TestServer server;

  @BeforeEach
  void connect() {
    rig = new Rig(folder);
    server = rig.connect();
  }

  @AfterEach
  void close() {
    rig.close();
  }
}
