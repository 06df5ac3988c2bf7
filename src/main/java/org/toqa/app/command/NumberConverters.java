package org.toqa.app.command;

import java.util.function.Function;
import picocli.CommandLine;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Reads the numbers of options, and says without Java's words what is none. */
public final class NumberConverters {
  private NumberConverters() {}

  /** Sets them for a command and its subcommands. */
  public static CommandLine register(CommandLine commands) {
    return commands
        .registerConverter(Integer.class, reader(Integer::valueOf, "whole number"))
        .registerConverter(int.class, reader(Integer::valueOf, "whole number"))
        .registerConverter(Long.class, reader(Long::valueOf, "whole number"))
        .registerConverter(long.class, reader(Long::valueOf, "whole number"))
        .registerConverter(Double.class, reader(Double::valueOf, "number"))
        .registerConverter(double.class, reader(Double::valueOf, "number"));
  }

  private static <T> ITypeConverter<T> reader(Function<String, T> reader, String kind) {
    return text -> {
      try {
        return reader.apply(text);
      } catch (NumberFormatException e) {
        throw new TypeConversionException("\"%s\" is not a %s".formatted(text, kind));
      }
    };
  }
}
