package org.toqa.store;

import com.github.benmanes.caffeine.cache.Cache;
import com.github.benmanes.caffeine.cache.Caffeine;
import java.sql.ResultSet;
import java.sql.SQLException;
import org.jdbi.v3.core.config.ConfigRegistry;
import org.jdbi.v3.core.mapper.RowMapper;
import org.jdbi.v3.core.mapper.reflect.ConstructorMapper;
import org.jdbi.v3.core.statement.StatementContext;

/**
 * Reads records from rows as {@link ConstructorMapper} does, and keeps which column each component
 * comes from for as long as a statement is in use: finding that out takes longer than reading a
 * row.
 *
 * @param <T> the record
 */
final class RowMapperCache<T> implements RowMapper<T> {
  /** Statements of each record; there are more only of those with a list of values. */
  private static final int MAX_STATEMENTS = 200;

  private final RowMapper<T> mapper;
  private final Cache<String, RowMapper<T>> byStatement =
      Caffeine.newBuilder().maximumSize(MAX_STATEMENTS).build();

  RowMapperCache(Class<T> type) {
    mapper = ConstructorMapper.of(type);
  }

  @Override
  public void init(ConfigRegistry registry) {
    mapper.init(registry);
  }

  @Override
  public T map(ResultSet row, StatementContext context) throws SQLException {
    return mapper.map(row, context);
  }

  @Override
  public RowMapper<T> specialize(ResultSet rows, StatementContext context) throws SQLException {
    String sql = context.getRenderedSql();
    RowMapper<T> known = byStatement.getIfPresent(sql);
    if (known == null) {
      known = mapper.specialize(rows, context);
      byStatement.put(sql, known);
    }
    return known;
  }
}
