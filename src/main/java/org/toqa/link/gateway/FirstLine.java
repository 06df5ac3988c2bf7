package org.toqa.link.gateway;

import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import org.toqa.link.message.DecodeResult.Decoded;
import org.toqa.link.message.GatewayMessage;
import org.toqa.link.message.LineReader;
import org.toqa.link.message.LinkCodec;

/** Reads what a connection is for, and not a byte more: the next ones are somebody else's. */
final class FirstLine {

  private static final int MAX_BYTES = 200;

  private FirstLine() {}

  /**
   * Waits for it.
   *
   * @throws IOException if it is none, or the connection ends
   */
  static GatewayMessage read(InputStream in) throws IOException {
    ByteArrayOutputStream line = new ByteArrayOutputStream();
    for (int next = in.read(); next != '\n'; next = in.read()) {
      if (next < 0) {
        throw new EOFException("it ended before its first line");
      }
      if (line.size() == MAX_BYTES) {
        throw new IOException("its first line is too long");
      }
      line.write(next);
    }
    if (LinkCodec.decodeGatewayMessage(new LineReader.Text(line.toByteArray()))
        instanceof Decoded<GatewayMessage>(GatewayMessage message)) {
      return message;
    }
    throw new IOException("its first line does not say what it is for");
  }
}
