package org.u2sa.scenarios.camera;

import java.awt.image.BufferedImage;
import java.io.EOFException;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.Optional;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.FileImageInputStream;
import javax.imageio.stream.ImageInputStream;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.device.port.CameraFrame.Intrinsics;
import org.u2sa.device.port.CameraFrame.PixelFormat;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.DecodingLimit;
import org.u2sa.interfaces.disk.RegularFile;

/** Reads images from files as camera frames. */
final class CameraPicture {
  private static final long MAX_PIXELS = 1L << 25;
  private static final int BYTES_PER_PIXEL = 24; // that a decoder of progressive images may need
  private static final DecodingLimit LIMIT =
      new DecodingLimit(
          Math.min(MAX_PIXELS, Runtime.getRuntime().maxMemory() / BYTES_PER_PIXEL),
          DecodingLimit.MAX_SCANNED_AT_LEISURE);

  private CameraPicture() {}

  /**
   * Reads a PNG, JPEG, BMP or GIF file as RGB24.
   *
   * @throws BadInputException if the image is missing, unreadable or too large; names the file
   */
  static CameraFrame read(Path file) {
    RegularFile.require(file, "a PNG, JPEG, BMP or GIF picture");
    try (ImageInputStream in = new FileImageInputStream(file.toFile())) {
      return frame(in, 0L, Optional.empty());
    } catch (IOException e) {
      throw new BadInputException(file + ": " + e.getMessage(), e);
    }
  }

  /**
   * Reads an image without closing the stream.
   *
   * @throws IOException if the image is unreadable or too large
   */
  static CameraFrame frame(ImageInputStream in, long micros, Optional<Intrinsics> intrinsics)
      throws IOException {
    long scans = DecodingLimit.scans(in::read);
    in.seek(0);
    Iterator<ImageReader> readers = ImageIO.getImageReaders(in);
    if (!readers.hasNext()) {
      throw new IOException("is damaged");
    }
    ImageReader reader = readers.next();
    try {
      reader.setInput(in, true, true);
      LIMIT.require(reader.getWidth(0), reader.getHeight(0), scans);
      return frame(reader.read(0), micros, intrinsics);
    } catch (EOFException e) {
      throw new IOException("ends too early", e);
    } catch (RuntimeException e) { // decoders throw these for damaged files
      throw new IOException("is damaged: " + e, e);
    } finally {
      reader.dispose();
    }
  }

  private static CameraFrame frame(
      BufferedImage image, long micros, Optional<Intrinsics> intrinsics) {
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
