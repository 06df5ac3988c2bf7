package org.toqa.app.bench;

import org.jspecify.annotations.Nullable;
import org.toqa.app.command.Arguments;
import org.toqa.store.Database;
import picocli.CommandLine.Option;

/** {@code --database}: where the server of a bench keeps its data. */
final class DatabaseOption {
  @Option(
      names = "--database",
      paramLabel = "URL",
      description =
          "JDBC URL of an empty database, such as jdbc:mysql://HOST/NAME?user=U&password=P"
              + " (default: H2 in a folder that is deleted afterwards).")
  private @Nullable String url;

  /**
   * @throws picocli.CommandLine.ParameterException when it is none that can be used
   */
  void check(Arguments arguments) {
    if (url != null && !Database.isSupported(url)) {
      throw arguments.invalid(
          "--database must be a JDBC URL that begins with jdbc:mysql: or jdbc:h2:");
    }
  }

  /** Null: the server's own. */
  @Nullable String value() {
    return url;
  }
}
