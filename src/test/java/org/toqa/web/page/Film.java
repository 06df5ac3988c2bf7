package org.toqa.web.page;

import com.microsoft.playwright.Page;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.ImageOutputStream;

/** What somebody saw, one picture before each thing that he did, as an animated GIF. */
final class Film implements AutoCloseable {
  private static final Path FOLDER = Path.of("target/film");
  private static final String FORMAT = "javax_imageio_gif_image_1.0";
  private static final String CENTISECONDS = "70"; // for which each picture is shown

  private final ImageWriter writer = ImageIO.getImageWritersByFormatName("gif").next();
  private final ImageOutputStream file;

  Film(String name) {
    try {
      Files.createDirectories(FOLDER);
      Path path = FOLDER.resolve(name + ".gif");
      Files.deleteIfExists(path);
      file = ImageIO.createImageOutputStream(path.toFile());
      writer.setOutput(file);
      writer.prepareWriteSequence(null);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** The page as it is now. */
  void take(Page page) {
    try {
      BufferedImage picture = ImageIO.read(new ByteArrayInputStream(page.screenshot()));
      writer.writeToSequence(new IIOImage(picture, null, timing(picture)), null);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private IIOMetadata timing(BufferedImage picture) throws IOException {
    IIOMetadata metadata =
        writer.getDefaultImageMetadata(
            ImageTypeSpecifier.createFromRenderedImage(picture), writer.getDefaultWriteParam());
    IIOMetadataNode root = new IIOMetadataNode(FORMAT);
    IIOMetadataNode control = new IIOMetadataNode("GraphicControlExtension");
    control.setAttribute("disposalMethod", "none");
    control.setAttribute("userInputFlag", "FALSE");
    control.setAttribute("transparentColorFlag", "FALSE");
    control.setAttribute("transparentColorIndex", "0");
    control.setAttribute("delayTime", CENTISECONDS);
    root.appendChild(control);
    metadata.mergeTree(FORMAT, root);
    return metadata;
  }

  @Override
  public void close() {
    try {
      writer.endWriteSequence();
      file.close();
      writer.dispose();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
