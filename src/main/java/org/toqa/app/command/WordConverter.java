package org.toqa.app.command;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Reads one of a few words, the names of an enum in lower case, with hyphens. */
public abstract class WordConverter<E extends Enum<E>> implements ITypeConverter<E> {
  private final List<E> choices;

  protected WordConverter(E[] choices) {
    this.choices = List.of(choices);
  }

  /**
   * @throws TypeConversionException it is none of the words; names them
   */
  @Override
  public E convert(String text) {
    return choices.stream()
        .filter(choice -> wordOf(choice).equals(text))
        .findFirst()
        .orElseThrow(() -> new TypeConversionException("it is " + choiceList() + ", not " + text));
  }

  private String choiceList() {
    String[] words = choices.stream().map(WordConverter::wordOf).toArray(String[]::new);
    int last = words.length - 1;
    return String.join(", ", Arrays.copyOf(words, last)) + " or " + words[last];
  }

  private static String wordOf(Enum<?> choice) {
    return choice.name().toLowerCase(Locale.ROOT).replace('_', '-');
  }
}
