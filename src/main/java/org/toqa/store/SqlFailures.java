package org.toqa.store;

import java.sql.SQLDataException;
import java.sql.SQLException;
import java.sql.SQLIntegrityConstraintViolationException;
import java.sql.SQLTimeoutException;
import java.util.Set;
import org.toqa.persistence.StoreException;

/**
 * What kind of failure the database's word is, by the class of its SQLSTATE, the first two
 * characters.
 *
 * <p>Refused is what is due to the data of this one statement, or to this program where no word of
 * the database is found. All else would happen to every statement alike, such as a lost connection,
 * a full disk, a server that only reads, a right that was taken or a table that is being restored:
 * it is tried again.
 */
final class SqlFailures {
  /** Cardinality, data, and integrity constraints. */
  private static final Set<String> REFUSED_CLASSES = Set.of("21", "22", "23");

  /** MySQL has no SQLSTATE of its own for these: a text in a wrong character set, a check. */
  private static final Set<Integer> REFUSED_CODES = Set.of(1366, 3819);

  /** H2's and MySQL's: somebody else has stored it meanwhile, and who asks again finds it. */
  private static final Set<Integer> DUPLICATE_CODES = Set.of(23505, 1062);

  /** SQLSTATE of who waited for another in a circle, and was ended for the other's sake. */
  private static final String DEADLOCK = "40001";

  /** Connector/J's, of a statement that is larger than the server takes. */
  private static final String TOO_LARGE = "S1000";

  /** MySQL's, of a query that was ended by max_execution_time. */
  private static final int TOO_SLOW_CODE = 3024;

  private SqlFailures() {}

  static StoreException.Kind kind(Throwable failure) {
    for (Throwable cause = failure; cause != null; cause = cause.getCause()) {
      if (cause instanceof SQLException said) {
        return kind(said);
      }
    }
    return StoreException.Kind.REFUSED;
  }

  private static StoreException.Kind kind(SQLException said) {
    if (said instanceof SQLTimeoutException || said.getErrorCode() == TOO_SLOW_CODE) {
      return StoreException.Kind.TOO_SLOW;
    }
    String state = said.getSQLState() == null ? "" : said.getSQLState();
    if (DUPLICATE_CODES.contains(said.getErrorCode()) || state.equals(DEADLOCK)) {
      return StoreException.Kind.OVERTAKEN;
    }
    boolean isRefused =
        said instanceof SQLDataException
            || said instanceof SQLIntegrityConstraintViolationException
            || (state.length() == 5 && REFUSED_CLASSES.contains(state.substring(0, 2)))
            || REFUSED_CODES.contains(said.getErrorCode())
            || state.equals(TOO_LARGE);
    return isRefused ? StoreException.Kind.REFUSED : StoreException.Kind.UNAVAILABLE;
  }
}
