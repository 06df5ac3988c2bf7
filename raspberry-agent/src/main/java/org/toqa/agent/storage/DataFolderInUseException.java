package org.toqa.agent.storage;

import java.io.IOException;
import java.nio.file.Path;

/** A daemon runs on that folder already. */
public final class DataFolderInUseException extends IOException {
  private static final long serialVersionUID = 1;

  DataFolderInUseException(Path folder) {
    super("The data folder " + folder + " is in use by another daemon.");
  }
}
