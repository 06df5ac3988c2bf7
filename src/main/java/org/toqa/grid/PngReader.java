package org.toqa.grid;

import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.awt.image.Raster;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import javax.imageio.stream.MemoryCacheImageInputStream;

/** Reads PNG pictures; colours become the mean of their channels, as in ROS map_server. */
final class PngReader {
  private PngReader() {}

  static GreyImage read(MapFile file) throws MapFormatException {
    byte[] bytes = file.read(MapLimits.MAX_MAP_BYTES);
    ImageReader reader = ImageIO.getImageReadersByFormatName("png").next();
    try (ImageInputStream in = new MemoryCacheImageInputStream(new ByteArrayInputStream(bytes))) {
      reader.setInput(in);
      MapLimits.checkSize(file, reader.getWidth(0), reader.getHeight(0));
      return grey(reader.read(0));
    } catch (MapFormatException e) {
      throw e;
    } catch (IOException | RuntimeException e) { // the decoder throws both on a damaged file
      throw new MapFormatException(file + " is not a readable PNG picture; save it again.", e);
    } finally {
      reader.dispose();
    }
  }

  // Samples of the raster, not getRGB: that would bend the greys by a colour profile.
  private static GreyImage grey(BufferedImage image) {
    int width = image.getWidth();
    int height = image.getHeight();
    Raster raster = image.getRaster();
    if (image.getColorModel() instanceof IndexColorModel palette) {
      return new GreyImage(
          width,
          height,
          i -> {
            int entry = raster.getSample(i % width, i / width, 0);
            return palette.getAlpha(entry) == 0
                ? Double.NaN
                : (palette.getRed(entry) + palette.getGreen(entry) + palette.getBlue(entry))
                    / (3 * 255.0);
          });
    }
    int alphaBand = image.getColorModel().hasAlpha() ? raster.getNumBands() - 1 : -1;
    int colours = raster.getNumBands() - (alphaBand < 0 ? 0 : 1);
    double white = Math.pow(2, image.getColorModel().getComponentSize(0)) - 1;
    return new GreyImage(
        width,
        height,
        i -> {
          int x = i % width;
          int y = i / width;
          if (alphaBand >= 0 && raster.getSample(x, y, alphaBand) == 0) {
            return Double.NaN;
          }
          int sum = 0;
          for (int band = 0; band < colours; band++) {
            sum += raster.getSample(x, y, band);
          }
          return sum / (colours * white);
        });
  }
}
