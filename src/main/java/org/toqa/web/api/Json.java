package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Locale;
import org.toqa.web.Texts;
import org.toqa.wording.Sentence;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.StreamReadFeature;
import tools.jackson.databind.ObjectWriter;
import tools.jackson.databind.SerializationContext;
import tools.jackson.databind.ValueSerializer;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.module.SimpleModule;

/** Reads and writes JSON, strictly. */
public final class Json {
  static final JsonMapper MAPPER =
      JsonMapper.builder()
          .enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION)
          .addModule(new SimpleModule().addSerializer(Sentence.class, new SentenceSerializer()))
          .build();

  private Json() {}

  /** What the fleet says is written in the language of the writer. */
  private static final class SentenceSerializer extends ValueSerializer<Sentence> {
    @Override
    public void serialize(Sentence said, JsonGenerator to, SerializationContext context) {
      to.writeString(said.text(context.getLocale()));
    }
  }

  public static ObjectWriter writer(Locale locale) {
    return MAPPER.writer().with(locale);
  }

  static void send(
      HttpServletRequest request, HttpServletResponse response, int status, Object body)
      throws IOException {
    send(request, response, status, "application/json", body);
  }

  static void send(
      HttpServletRequest request,
      HttpServletResponse response,
      int status,
      String mediaType,
      Object body)
      throws IOException {
    Texts texts = Texts.of(request);
    texts.setContentLanguage(response);
    byte[] bytes = writer(texts.locale()).writeValueAsBytes(body);
    response.setStatus(status);
    response.setContentType(mediaType);
    response.setContentLength(bytes.length);
    response.getOutputStream().write(bytes);
  }
}
