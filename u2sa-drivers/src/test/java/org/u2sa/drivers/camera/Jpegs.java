package org.u2sa.drivers.camera;

import static java.nio.charset.StandardCharsets.US_ASCII;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import javax.imageio.ImageIO;

/** JPEG files as the JDK writes them, and what a network camera says around them. */
final class Jpegs {
  private Jpegs() {}

  /** A picture whose left half is nearly black and whose right half is nearly white. */
  static byte[] darkThenBright(int width, int height) {
    BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_BYTE_GRAY);
    for (int x = 0; x < width; x++) {
      for (int y = 0; y < height; y++) {
        image.setRGB(x, y, x < width / 2 ? 0x101010 : 0xF0F0F0);
      }
    }
    ByteArrayOutputStream file = new ByteArrayOutputStream();
    try {
      ImageIO.write(image, "jpg", file);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return file.toByteArray();
  }

  static byte[] head() {
    return "HTTP/1.0 200 OK\r\nContent-Type: multipart/x-mixed-replace;boundary=b\r\n\r\n"
        .getBytes(US_ASCII);
  }

  static byte[] part(byte[] jpeg) {
    String head = "--b\r\nContent-Type: image/jpeg\r\nContent-Length: " + jpeg.length + "\r\n\r\n";
    ByteArrayOutputStream part = new ByteArrayOutputStream();
    part.writeBytes(head.getBytes(US_ASCII));
    part.writeBytes(jpeg);
    part.writeBytes("\r\n".getBytes(US_ASCII));
    return part.toByteArray();
  }
}
