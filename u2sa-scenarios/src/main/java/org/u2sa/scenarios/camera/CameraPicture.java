package org.u2sa.scenarios.camera;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import javax.imageio.ImageIO;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.device.port.CameraFrame.Intrinsics;
import org.u2sa.device.port.CameraFrame.PixelFormat;
import org.u2sa.interfaces.BadInputException;

/** Reads images from files as camera frames. */
final class CameraPicture {
  private CameraPicture() {}

  /**
   * Reads a PNG, JPEG, BMP or GIF file as RGB24.
   *
   * @throws BadInputException if the image is missing or unreadable; names the file
   */
  static CameraFrame read(Path file) {
    try (InputStream in = Files.newInputStream(file)) {
      return frame(file.toString(), in, 0L, Optional.empty());
    } catch (IOException e) {
      throw new BadInputException(file + ": cannot be read: " + e.getMessage(), e);
    }
  }

  /** Reads an image from a stream without closing it. */
  static CameraFrame frame(
      String origin, InputStream in, long micros, Optional<Intrinsics> intrinsics)
      throws IOException {
    BufferedImage image = ImageIO.read(in);
    if (image == null) {
      throw new BadInputException(origin + ": is not a PNG, JPEG, BMP or GIF picture");
    }
    int width = image.getWidth();
    int height = image.getHeight();
    int[] row = new int[width];
    byte[] pixels = new byte[3 * width * height];
    for (int y = 0, at = 0; y < height; y++) {
      image.getRGB(0, y, width, 1, row, 0, width);
      for (int rgb : row) {
        pixels[at++] = (byte) (rgb >> 16);
        pixels[at++] = (byte) (rgb >> 8);
        pixels[at++] = (byte) rgb;
      }
    }
    return new CameraFrame(micros, width, height, PixelFormat.RGB24, pixels, intrinsics);
  }

  /** Image of an uncompressed frame. */
  static BufferedImage image(CameraFrame frame) {
    BufferedImage image =
        new BufferedImage(frame.width(), frame.height(), BufferedImage.TYPE_INT_RGB);
    byte[] pixels = frame.pixels();
    int step = frame.format().bytesPerPixel();
    for (int y = 0, at = 0; y < frame.height(); y++) {
      for (int x = 0; x < frame.width(); x++, at += step) {
        int red = pixels[at] & 0xFF;
        int green = step == 1 ? red : pixels[at + 1] & 0xFF;
        int blue = step == 1 ? red : pixels[at + 2] & 0xFF;
        image.setRGB(x, y, red << 16 | green << 8 | blue);
      }
    }
    return image;
  }
}
