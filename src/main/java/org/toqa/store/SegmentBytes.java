package org.toqa.store;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import org.toqa.motion.Segment;

/**
 * Segments as they are kept in {@code drive_segments.segments}: of each v, w and t, a third of what
 * they take as text.
 */
final class SegmentBytes {
  private static final int SEGMENT_BYTES = 3 * Double.BYTES;

  /** What a row takes. */
  static final int MOST_SEGMENTS = 3072 / SEGMENT_BYTES;

  private SegmentBytes() {}

  /**
   * @return of one row each; one also where there are no segments
   */
  static List<byte[]> write(List<Segment> segments) {
    List<byte[]> rows = new ArrayList<>();
    int first = 0;
    do {
      int end = Math.min(segments.size(), first + MOST_SEGMENTS);
      rows.add(row(segments.subList(first, end)));
      first = end;
    } while (first < segments.size());
    return rows;
  }

  private static byte[] row(List<Segment> segments) {
    ByteBuffer bytes = ByteBuffer.allocate(SEGMENT_BYTES * segments.size());
    segments.forEach(s -> bytes.putDouble(s.v()).putDouble(s.w()).putDouble(s.t()));
    return bytes.array();
  }

  /** How many segments those are. */
  static int count(byte[] row) {
    return row.length / SEGMENT_BYTES;
  }

  static List<Segment> read(byte[] row) {
    ByteBuffer bytes = ByteBuffer.wrap(row);
    List<Segment> segments = new ArrayList<>(count(row));
    while (bytes.hasRemaining()) {
      segments.add(new Segment(bytes.getDouble(), bytes.getDouble(), bytes.getDouble()));
    }
    return segments;
  }
}
