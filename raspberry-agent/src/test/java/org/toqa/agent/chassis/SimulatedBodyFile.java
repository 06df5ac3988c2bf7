package org.toqa.agent.chassis;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import org.toqa.geometry.Pose;

/** A simulated body as its file tells it, whether its daemon runs, is frozen or was killed. */
public final class SimulatedBodyFile implements AutoCloseable {
  private final SimulatedChassisFile file;

  /**
   * @param truePose where it really is, map frame
   * @param battery 0 to 1
   * @param steps simulated so far, of 20 ms at most
   */
  public record Reading(Pose truePose, double battery, long steps) {}

  /**
   * @param folder the daemon's
   */
  public SimulatedBodyFile(Path folder) throws IOException {
    file = new SimulatedChassisFile(folder.resolve("body"));
  }

  /** Empty until it was written once. */
  public Optional<Reading> read() {
    while (true) {
      long before = count();
      Optional<SimulatedChassisState> state = file.read();
      if (count() == before) { // else it was written meanwhile, and may be torn
        return state.map(s -> new Reading(s.truePose(), s.battery(), s.steps()));
      }
    }
  }

  /** How often it was written, in all: the same as before, and nothing has changed. */
  public long count() {
    return file.count();
  }

  @Override
  public void close() {
    file.close();
  }
}
