package org.toqa.link;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.toqa.link.message.LineReader;
import org.toqa.link.message.LineReader.Line;
import org.toqa.link.message.LineReader.Text;

/**
 * Tells of two lines that have come, without reading them, whether the later one says all that is
 * worth knowing of the first: both are states with the same errors, written as our daemon writes
 * them (type first, errors last). Of other robots every state is read.
 */
final class StateLines {
  private static final byte[] TYPE = bytes("{\"type\":\"state\",");
  private static final byte[] ERRORS = bytes("\"errors\":[");

  private StateLines() {}

  static boolean isSuperseded(Line line, LineReader.Line next) {
    return line instanceof Text(byte[] older)
        && next instanceof Text(byte[] newer)
        && isState(older)
        && isState(newer)
        && haveSameErrors(older, newer);
  }

  private static boolean isState(byte[] line) {
    return line.length > TYPE.length && Arrays.equals(line, 0, TYPE.length, TYPE, 0, TYPE.length);
  }

  private static boolean haveSameErrors(byte[] older, byte[] newer) {
    int length = newer.length - errorsIndex(newer);
    return errorsIndex(newer) >= 0
        && length <= older.length
        && errorsIndex(older) == older.length - length
        && Arrays.equals(
            older, older.length - length, older.length, newer, newer.length - length, newer.length);
  }

  /** Of the last field of that name; -1: there is none. */
  private static int errorsIndex(byte[] line) {
    for (int i = line.length - ERRORS.length; i >= 0; i--) {
      if (Arrays.equals(line, i, i + ERRORS.length, ERRORS, 0, ERRORS.length)) {
        return i;
      }
    }
    return -1;
  }

  private static byte[] bytes(String ascii) {
    return ascii.getBytes(StandardCharsets.US_ASCII);
  }
}
