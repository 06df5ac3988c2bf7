package org.toqa.app.command;

import java.math.BigDecimal;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/**
 * A place on the command line, {@code X,Y} or {@code X,Y,DEG}.
 *
 * @param position metres, map frame
 * @param heading radians, counter-clockwise from map east; null where none was given
 */
public record PlaceArgument(Vec2 position, @Nullable Double heading) {
  /** Limit of a coordinate, metres; more than any map has. */
  private static final double MAX_METRES = 1e6;

  private static final double MAX_DEGREES = 360;

  /** Reads {@code X,Y}. */
  public static final class PointConverter implements ITypeConverter<PlaceArgument> {
    @Override
    public PlaceArgument convert(String text) {
      return read(text, 2, "X,Y in metres, such as 1.95,4.65");
    }
  }

  /** Reads {@code X,Y} or {@code X,Y,DEG}. */
  public static final class PoseConverter implements ITypeConverter<PlaceArgument> {
    @Override
    public PlaceArgument convert(String text) {
      return read(text, 3, "X,Y in metres or X,Y,DEG, such as 1.95,4.65,90");
    }
  }

  private static PlaceArgument read(String text, int most, String expected) {
    String[] parts = text.split(",", -1);
    if (parts.length < 2 || parts.length > most) {
      throw new TypeConversionException("expected " + expected + ", not \"" + text + "\"");
    }
    Vec2 position = new Vec2(number(parts[0], MAX_METRES), number(parts[1], MAX_METRES));
    return new PlaceArgument(
        position, parts.length < 3 ? null : Math.toRadians(number(parts[2], MAX_DEGREES)));
  }

  private static double number(String text, double most) {
    try {
      double number = new BigDecimal(text.strip()).doubleValue();
      if (Math.abs(number) <= most) {
        return number;
      }
    } catch (NumberFormatException e) {
      // the sentence below names what stands there
    }
    throw new TypeConversionException(
        "\"%s\" is not a number from %.0f to %.0f".formatted(text, -most, most));
  }
}
