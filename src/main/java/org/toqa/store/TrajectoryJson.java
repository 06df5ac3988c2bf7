package org.toqa.store;

import org.toqa.motion.Trajectory;
import tools.jackson.databind.json.JsonMapper;

/** A way as it stands in the column {@code drives.way}. */
final class TrajectoryJson {
  private static final JsonMapper MAPPER = JsonMapper.builder().build();

  private TrajectoryJson() {}

  static String write(Trajectory way) {
    return MAPPER.writeValueAsString(way);
  }

  static Trajectory read(String json) {
    return MAPPER.readValue(json, Trajectory.class);
  }
}
