package org.toqa.grid;

/** Reads portable grey maps, in text (P2) and binary (P5), of 8 and 16 bits. */
final class PgmReader {
  private final MapFile file;
  private final byte[] bytes;
  private int at;

  private PgmReader(MapFile file, byte[] bytes) {
    this.file = file;
    this.bytes = bytes;
  }

  static GreyImage read(MapFile file) throws MapFormatException {
    return new PgmReader(file, file.read(MapLimits.MAX_MAP_BYTES)).image();
  }

  private GreyImage image() throws MapFormatException {
    boolean inText = bytes.length >= 2 && bytes[0] == 'P' && bytes[1] == '2';
    boolean binary = bytes.length >= 2 && bytes[0] == 'P' && bytes[1] == '5';
    if (!inText && !binary) {
      throw new MapFormatException(
          file + " is not a grey map: it must start with P2 or P5; save it as PGM or PNG.");
    }
    at = 2;
    int width = number("width");
    int height = number("height");
    int white = number("largest grey value");
    MapLimits.checkSize(file, width, height);
    if (white < 1 || white > 65535) {
      throw new MapFormatException(
          file + ": the largest grey value is " + white + "; it must lie between 1 and 65535.");
    }
    int[] values = inText ? textValues(width * height) : binaryValues(width * height, white);
    for (int i = 0; i < values.length; i++) {
      if (values[i] > white) {
        throw new MapFormatException(
            "%s: column %d, row %d has grey value %d, more than the file's largest, %d."
                .formatted(file, i % width, i / width, values[i], white));
      }
    }
    return new GreyImage(width, height, i -> (double) values[i] / white);
  }

  private int[] textValues(int count) throws MapFormatException {
    int[] values = new int[count];
    for (int i = 0; i < count; i++) {
      values[i] = number("grey value " + (i + 1) + " of " + count);
    }
    return values;
  }

  private int[] binaryValues(int count, int white) throws MapFormatException {
    at++; // one white space ends the header
    int size = white > 255 ? 2 : 1;
    if (bytes.length - at < (long) count * size) {
      throw new MapFormatException(
          "%s ends after %d of %d pixels; save it again."
              .formatted(file, Math.max(0, bytes.length - at) / size, count));
    }
    int[] values = new int[count];
    for (int i = 0; i < count; i++) {
      values[i] = bytes[at++] & 0xFF;
      if (size == 2) {
        values[i] = values[i] << 8 | (bytes[at++] & 0xFF);
      }
    }
    return values;
  }

  /** The next number of the header or of a P2 picture; '#' starts a comment. */
  private int number(String what) throws MapFormatException {
    while (at < bytes.length && (bytes[at] == '#' || Character.isWhitespace(bytes[at]))) {
      if (bytes[at] == '#') {
        while (at < bytes.length && bytes[at] != '\n') {
          at++;
        }
      } else {
        at++;
      }
    }
    int start = at;
    int value = 0;
    while (at < bytes.length && bytes[at] >= '0' && bytes[at] <= '9' && at - start < 9) {
      value = value * 10 + bytes[at++] - '0';
    }
    if (at == start || at - start == 9) {
      throw new MapFormatException(
          "%s: the %s is missing or not a usable number (byte %d); save it again."
              .formatted(file, what, start + 1));
    }
    return value;
  }
}
