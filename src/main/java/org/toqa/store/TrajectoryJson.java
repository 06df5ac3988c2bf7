package org.toqa.store;

import java.util.List;
import org.toqa.motion.Segment;
import org.toqa.motion.Trajectory;
import tools.jackson.databind.json.JsonMapper;

/** A trajectory as it is kept in {@code drives.way}, and a part in {@code drive_ends.segments}. */
final class TrajectoryJson {
  private static final JsonMapper MAPPER = JsonMapper.builder().build();

  private TrajectoryJson() {}

  static String write(Trajectory trajectory) {
    return MAPPER.writeValueAsString(trajectory);
  }

  static Trajectory read(String json) {
    return MAPPER.readValue(json, Trajectory.class);
  }

  static String writeSegments(List<Segment> segments) {
    return MAPPER.writeValueAsString(segments);
  }

  static List<Segment> readSegments(String json) {
    return List.of(MAPPER.readValue(json, Segment[].class));
  }
}
