package org.toqa.store;

import org.toqa.motion.Trajectory;
import tools.jackson.databind.json.JsonMapper;

/** A trajectory as it is kept in the column {@code drives.way}. */
final class TrajectoryJson {
  private static final JsonMapper MAPPER = JsonMapper.builder().build();

  private TrajectoryJson() {}

  static String write(Trajectory trajectory) {
    return MAPPER.writeValueAsString(trajectory);
  }

  static Trajectory read(String json) {
    return MAPPER.readValue(json, Trajectory.class);
  }
}
