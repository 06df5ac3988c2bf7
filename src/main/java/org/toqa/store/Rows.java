package org.toqa.store;

import java.sql.ResultSet;
import java.sql.SQLException;
import java.time.Instant;
import java.time.LocalDateTime;
import java.time.ZoneOffset;
import org.jspecify.annotations.Nullable;
import org.toqa.mission.TransportTask.LoadSize;

/** Reads columns. */
final class Rows {
  private Rows() {}

  static Instant instant(ResultSet rs, String column) throws SQLException {
    return rs.getObject(column, LocalDateTime.class).toInstant(ZoneOffset.UTC);
  }

  static @Nullable Instant nullableInstant(ResultSet rs, String column) throws SQLException {
    return rs.getObject(column) == null ? null : instant(rs, column);
  }

  /** Null where nobody said it. */
  static @Nullable LoadSize loadSize(ResultSet rs) throws SQLException {
    Double length = nullableDouble(rs, "load_length");
    Double width = nullableDouble(rs, "load_width");
    return length == null || width == null ? null : new LoadSize(length, width);
  }

  static @Nullable Long nullableLong(ResultSet rs, String column) throws SQLException {
    long value = rs.getLong(column);
    return rs.wasNull() ? null : value;
  }

  static @Nullable Double nullableDouble(ResultSet rs, String column) throws SQLException {
    double value = rs.getDouble(column);
    return rs.wasNull() ? null : value;
  }
}
