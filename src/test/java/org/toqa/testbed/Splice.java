package org.toqa.testbed;

import java.io.ByteArrayOutputStream;

/** Bytes with others in place of a part of them, for inputs that are nearly right. */
public final class Splice {

  /**
   * @param from the first byte that is left out
   * @param to after the last one; where it is before {@code from}, that part stands twice
   */
  public static byte[] of(byte[] bytes, int from, byte[] middle, int to) {
    ByteArrayOutputStream joined = new ByteArrayOutputStream();
    joined.write(bytes, 0, from);
    joined.writeBytes(middle);
    joined.write(bytes, to, bytes.length - to);
    return joined.toByteArray();
  }

  private Splice() {}
}
