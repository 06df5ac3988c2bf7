package org.toqa.link.message;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.toqa.link.message.LineReader.Text;
import org.toqa.link.message.LineReader.TooLong;

class LineReaderTest {

  @Test
  void linesComeOneByOneWithoutTheirLineFeeds() throws IOException {
    LineReader lines = reader("one\n\ntwo\n");

    assertText("one", lines);
    assertText("", lines);
    assertText("two", lines);
    assertNull(lines.readLine());
  }

  @Test
  void lineThatIsCutOffIsDropped() throws IOException {
    LineReader lines = reader("one\n{\"type\":\"dri");

    assertText("one", lines);
    assertNull(lines.readLine());
  }

  @Test
  void longestLineIsRead() throws IOException {
    String longest = "x".repeat(LinkCodec.MAX_LINE_BYTES - 1);

    assertText(longest, reader(longest + "\n"));
  }

  @Test
  void lineOfAMegabyteIsToldAndTheNextOneRead() throws IOException {
    LineReader lines = reader("x".repeat(1_000_000) + "\nnext\n");

    assertEquals(new TooLong(1_000_001), lines.readLine());
    assertText("next", lines);
  }

  @Test
  void lineOfOneByteTooManyIsTold() throws IOException {
    assertEquals(
        new TooLong(LinkCodec.MAX_LINE_BYTES + 1),
        reader("x".repeat(LinkCodec.MAX_LINE_BYTES) + "\n").readLine());
  }

  private static LineReader reader(String text) {
    return new LineReader(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)));
  }

  private static void assertText(String expected, LineReader lines) throws IOException {
    Text text = assertInstanceOf(Text.class, assertNotNullLine(lines));
    assertArrayEquals(expected.getBytes(StandardCharsets.UTF_8), text.utf8());
  }

  private static LineReader.Line assertNotNullLine(LineReader lines) throws IOException {
    LineReader.Line line = lines.readLine();
    assertNotNull(line);
    return line;
  }
}
