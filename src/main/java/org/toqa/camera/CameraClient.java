package org.toqa.camera;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.Arrays;
import java.util.Base64;
import java.util.Locale;
import org.apache.hc.client5.http.SystemDefaultDnsResolver;
import org.apache.hc.client5.http.classic.methods.HttpGet;
import org.apache.hc.core5.http.ClassicHttpResponse;
import org.apache.hc.core5.http.Header;
import org.apache.hc.core5.http.HttpEntity;
import org.toqa.camera.PictureAnswer.Away;
import org.toqa.camera.PictureAnswer.Reason;
import org.toqa.camera.PictureAnswer.Shown;
import org.toqa.outbound.OutboundHttp;

/**
 * Asks cameras for one picture: for a still, or for the first picture of a stream (MJPEG, that is
 * {@code multipart/x-mixed-replace}). Size is bounded; what is no picture by its type and its first
 * bytes is not handed on, since a browser would trust it as this server's.
 */
final class CameraClient implements AutoCloseable {
  private static final Duration LIMIT = Duration.ofSeconds(3);

  /** Of a request as a whole, also of a camera that answers a byte now and then. */
  private static final Duration WHOLE_LIMIT = Duration.ofSeconds(5);

  private static final int MOST_BYTES = 2 << 20;
  private static final int MOST_CONNECTIONS = 32;
  private static final int OK = 200;
  private static final int LONGEST_LINE = 1000;
  private static final int MOST_LINES = 20;
  private static final String JPEG = "image/jpeg";
  private static final String PNG = "image/png";
  private static final String STREAM = "multipart/x-mixed-replace";

  private final OutboundHttp http =
      new OutboundHttp(
          "cameras", LIMIT, WHOLE_LIMIT, MOST_CONNECTIONS, SystemDefaultDnsResolver.INSTANCE);

  /** Its picture of now; waits for it. */
  PictureAnswer ask(URI url) {
    HttpGet request = new HttpGet(withoutUser(url));
    if (url.getUserInfo() != null) {
      byte[] user = url.getUserInfo().getBytes(StandardCharsets.UTF_8);
      request.setHeader("Authorization", "Basic " + Base64.getEncoder().encodeToString(user));
    }
    try {
      return http.send(request, CameraClient::read);
    } catch (IOException e) {
      return new Away(Reason.NO_ANSWER);
    }
  }

  private static URI withoutUser(URI url) {
    String text = url.toString();
    return url.getRawUserInfo() == null
        ? url
        : URI.create(text.replace(url.getRawUserInfo() + "@", ""));
  }

  private static PictureAnswer read(ClassicHttpResponse answer) throws IOException {
    HttpEntity entity = answer.getEntity();
    if (answer.getCode() != OK) {
      return new Away(Reason.REFUSED);
    }
    if (entity == null) {
      return new Away(Reason.NO_PICTURE);
    }
    Header type = answer.getFirstHeader("Content-Type");
    InputStream body = new BufferedInputStream(entity.getContent());
    String first = mediaType(type == null ? "" : type.getValue());
    return first.equals(STREAM) ? firstOf(body) : picture(first, body, MOST_BYTES + 1);
  }

  private static String mediaType(String header) {
    return header.split(";", 2)[0].strip().toLowerCase(Locale.ROOT);
  }

  /** A part has a line that bounds it, its headers, an empty line, and its bytes. */
  private static PictureAnswer firstOf(InputStream stream) throws IOException {
    String type = "";
    int length = -1;
    boolean isBounded = false;
    for (int lines = 0; lines < MOST_LINES; lines++) {
      String line = line(stream);
      String[] header = line.split(":", 2);
      if (line.startsWith("--")) {
        isBounded = true;
      } else if (line.isEmpty() && isBounded && !type.isEmpty()) {
        // Without a length the picture would end where the next part begins, a moment later.
        return length < 0 ? jpegUntilItsEnd(type, stream) : part(type, stream, length);
      } else if (header[0].equalsIgnoreCase("Content-Type")) {
        type = mediaType(header.length > 1 ? header[1] : "");
      } else if (header[0].equalsIgnoreCase("Content-Length")
          && header.length > 1
          && header[1].strip().matches("[0-9]{1,9}")) {
        length = Integer.parseInt(header[1].strip());
      }
    }
    return new Away(Reason.NO_PICTURE);
  }

  /** Without the line's end. */
  private static String line(InputStream stream) throws IOException {
    StringBuilder line = new StringBuilder();
    for (int next = stream.read(); next != '\n'; next = stream.read()) {
      if (next < 0 || line.length() > LONGEST_LINE) {
        throw new IOException("no line of a header");
      }
      line.append((char) next);
    }
    return line.toString().strip();
  }

  /**
   * A JPEG ends with the marker FF D9, which is nowhere else in what is compressed (T.81, B.1.1).
   */
  private static PictureAnswer jpegUntilItsEnd(String type, InputStream stream) throws IOException {
    if (!type.equals(JPEG)) {
      return new Away(Reason.NO_PICTURE);
    }
    byte[] bytes = new byte[MOST_BYTES];
    int last = 0;
    for (int count = 0; count < MOST_BYTES; count++) {
      int next = stream.read();
      if (next < 0) {
        return new Away(Reason.NO_ANSWER);
      }
      bytes[count] = (byte) next;
      if (last == 0xFF && next == 0xD9) {
        return checked(type, Arrays.copyOf(bytes, count + 1));
      }
      last = next;
    }
    return new Away(Reason.TOO_LARGE);
  }

  private static PictureAnswer part(String type, InputStream stream, int length)
      throws IOException {
    PictureAnswer answer = picture(type, stream, length);
    return answer instanceof Shown(byte[] bytes, _) && bytes.length < length
        ? new Away(Reason.NO_ANSWER)
        : answer;
  }

  private static PictureAnswer picture(String type, InputStream body, int length)
      throws IOException {
    if (!type.equals(JPEG) && !type.equals(PNG)) {
      return new Away(Reason.NO_PICTURE);
    }
    if (length > MOST_BYTES + 1) {
      return new Away(Reason.TOO_LARGE);
    }
    byte[] bytes = body.readNBytes(length);
    return bytes.length > MOST_BYTES ? new Away(Reason.TOO_LARGE) : checked(type, bytes);
  }

  /** What it says of itself must be what it begins like. */
  private static PictureAnswer checked(String type, byte[] bytes) {
    int[] begin =
        type.equals(JPEG) ? new int[] {0xFF, 0xD8, 0xFF} : new int[] {0x89, 'P', 'N', 'G'};
    for (int i = 0; i < begin.length; i++) {
      if (bytes.length <= i || (bytes[i] & 0xFF) != begin[i]) {
        return new Away(Reason.NO_PICTURE);
      }
    }
    return new Shown(bytes, type);
  }

  @Override
  public void close() throws IOException {
    http.close();
  }
}
