package org.toqa.svg;

import java.io.StringWriter;
import javax.xml.stream.XMLOutputFactory;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamWriter;

/** Writes a well-formed SVG document, whatever the texts in it. */
public final class SvgWriter {
  private final StringWriter text = new StringWriter();
  private final XMLStreamWriter xml;

  /**
   * Begins a document.
   *
   * @param width pixels
   * @param height pixels
   */
  public SvgWriter(double width, double height) {
    try {
      xml = XMLOutputFactory.newInstance().createXMLStreamWriter(text);
    } catch (XMLStreamException e) {
      throw unexpected(e);
    }
    open(
        "svg",
        "xmlns",
        "http://www.w3.org/2000/svg",
        "width",
        number(width),
        "height",
        number(height),
        "viewBox",
        "0 0 %s %s".formatted(number(width), number(height)));
  }

  /**
   * Begins an element.
   *
   * @param attributes names and values by turns
   */
  public void open(String name, String... attributes) {
    try {
      xml.writeStartElement(name);
      for (int i = 0; i < attributes.length; i += 2) {
        xml.writeAttribute(attributes[i], attributes[i + 1]);
      }
    } catch (XMLStreamException e) {
      throw unexpected(e);
    }
  }

  /** Ends the element that was begun last. */
  public void close() {
    try {
      xml.writeEndElement();
      xml.writeCharacters("\n");
    } catch (XMLStreamException e) {
      throw unexpected(e);
    }
  }

  /** An element with nothing inside. */
  public void element(String name, String... attributes) {
    open(name, attributes);
    close();
  }

  /** An element with a text inside. */
  public void text(String content, String name, String... attributes) {
    open(name, attributes);
    try {
      xml.writeCharacters(content);
    } catch (XMLStreamException e) {
      throw unexpected(e);
    }
    close();
  }

  /** A text of the page's size; its baseline begins at a point. */
  public void label(String content, double x, double y, String colour) {
    text(
        content,
        "text",
        "x",
        number(x),
        "y",
        number(y),
        "font-size",
        "14",
        "font-family",
        "sans-serif",
        "fill",
        colour);
  }

  /** A line along a path, with round ends and corners. */
  public void stroke(String path, String colour, double width) {
    element(
        "path",
        "d",
        path,
        "fill",
        "none",
        "stroke",
        colour,
        "stroke-width",
        number(width),
        "stroke-linecap",
        "round",
        "stroke-linejoin",
        "round");
  }

  /** Ends the document. */
  public String end() {
    try {
      xml.writeEndDocument();
      xml.close();
    } catch (XMLStreamException e) {
      throw unexpected(e);
    }
    return text.toString();
  }

  /** A coordinate with at most three decimals, and without trailing zeros. */
  public static String number(double value) {
    double rounded = Math.round(value * 1000) / 1000.0;
    return rounded == Math.rint(rounded) ? Long.toString((long) rounded) : Double.toString(rounded);
  }

  private static IllegalStateException unexpected(XMLStreamException e) {
    return new IllegalStateException("Writing into memory failed.", e);
  }
}
