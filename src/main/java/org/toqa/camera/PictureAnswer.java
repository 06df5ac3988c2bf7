package org.toqa.camera;

/** What a camera gave when it was asked for its picture. */
public sealed interface PictureAnswer {

  /**
   * @param bytes nobody changes them
   * @param type {@code image/jpeg} or {@code image/png}
   */
  @SuppressWarnings("ArrayRecordComponent") // a picture is neither compared nor changed
  record Shown(byte[] bytes, String type) implements PictureAnswer {}

  /** It gave none. */
  record Away(Reason reason) implements PictureAnswer {}

  /** Why there is no picture. */
  enum Reason {
    /** It did not answer in time, or not at all. */
    NO_ANSWER,
    /** It answered with another status than 200, such as where it wants a password. */
    REFUSED,
    /** It sent neither JPEG nor PNG, nor a stream of them. */
    NO_PICTURE,
    /** Its picture has more bytes than are read. */
    TOO_LARGE
  }
}
