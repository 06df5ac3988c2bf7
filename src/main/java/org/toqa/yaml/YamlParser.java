package org.toqa.yaml;

import org.jspecify.annotations.Nullable;
import org.yaml.snakeyaml.LoaderOptions;
import org.yaml.snakeyaml.Yaml;
import org.yaml.snakeyaml.constructor.SafeConstructor;
import org.yaml.snakeyaml.error.MarkedYAMLException;
import org.yaml.snakeyaml.error.YAMLException;

/**
 * Reads texts and numbers, lists and mappings, and never another type; a text from anywhere takes
 * little memory and time.
 */
public final class YamlParser {
  /** Characters of a text from anywhere. */
  private static final int MAX_LENGTH = 1 << 20;

  private static final int MAX_NESTING = 8;

  private YamlParser() {}

  /**
   * The one document of the text, of the types of {@code java.util} and {@code java.lang}.
   *
   * @return null for a text that says nothing
   * @throws YamlSyntaxException when it is not YAML, has a key twice, an alias of a collection or
   *     another type, or is too long or nested too deeply
   */
  public static @Nullable Object parse(String text) throws YamlSyntaxException {
    return parse(text, MAX_LENGTH);
  }

  /**
   * The same of a text that may be of another length.
   *
   * @param maxLength in characters
   */
  public static @Nullable Object parse(String text, int maxLength) throws YamlSyntaxException {
    LoaderOptions limits = new LoaderOptions();
    limits.setAllowDuplicateKeys(false);
    limits.setMaxAliasesForCollections(0);
    limits.setNestingDepthLimit(MAX_NESTING);
    limits.setCodePointLimit(maxLength);
    try {
      return new Yaml(new SafeConstructor(limits)).load(text);
    } catch (MarkedYAMLException e) {
      int line = e.getProblemMark() == null ? 1 : e.getProblemMark().getLine() + 1;
      throw new YamlSyntaxException(line, SyntaxAdvice.of(String.valueOf(e.getProblem())), e);
    } catch (YAMLException e) {
      throw new YamlSyntaxException(0, SyntaxAdvice.of(String.valueOf(e.getMessage())), e);
    } catch (IllegalArgumentException e) { // a word that is not of the type that its tag names
      throw new YamlSyntaxException(0, SyntaxAdvice.of("tag"), e);
    }
  }
}
