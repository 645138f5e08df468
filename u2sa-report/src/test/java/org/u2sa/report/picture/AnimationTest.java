package org.u2sa.report.picture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import org.junit.jupiter.api.Test;

class AnimationTest {
  private static final int SIDE = 64;

  @Test
  void add_fewColours_areReadBackExactly() throws IOException {
    BufferedImage first = filled(new Color(0x123456));
    BufferedImage second = filled(new Color(0xFEDCBA));
    second.setRGB(3, 5, 0xFF0102);

    ImageReader reader = written(first, second);

    assertEquals(2, reader.getNumImages(true));
    assertEquals(0xFF123456, reader.read(0).getRGB(10, 10));
    assertEquals(0xFFFEDCBA, reader.read(1).getRGB(10, 10));
    assertEquals(0xFFFF0102, reader.read(1).getRGB(3, 5));
  }

  @Test
  void add_moreColoursThanGifHolds_keepsFrequentAndComesCloseToOthers() throws IOException {
    BufferedImage image = filled(new Color(0x123456));
    for (int y = 0; y < SIDE / 2; y++) {
      for (int x = 0; x < SIDE; x++) {
        image.setRGB(x, y, x << 18 | y << 11 | 0x40); // 1,024 groups of colours
      }
    }

    BufferedImage read = written(image).read(0);

    assertEquals(0xFF123456, read.getRGB(10, SIDE - 1));
    double sum = 0.0;
    for (int y = 0; y < SIDE / 2; y++) {
      for (int x = 0; x < SIDE; x++) {
        sum +=
            Math.abs((read.getRGB(x, y) >> 16 & 0xFF) - (x << 2))
                + Math.abs((read.getRGB(x, y) >> 8 & 0xFF) - (y << 3));
      }
    }
    double mean = sum / (SIDE * SIDE / 2);
    assertTrue(mean > 0.0 && mean < 100.0, () -> "mean error " + mean);
  }

  private static BufferedImage filled(Color colour) {
    BufferedImage image = new BufferedImage(SIDE, SIDE, BufferedImage.TYPE_INT_RGB);
    Graphics2D graphics = image.createGraphics();
    graphics.setColor(colour);
    graphics.fillRect(0, 0, SIDE, SIDE);
    graphics.dispose();
    return image;
  }

  private static ImageReader written(BufferedImage... frames) throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try (Animation animation = new Animation(out, 8)) {
      for (BufferedImage frame : frames) {
        animation.add(frame);
      }
    }
    ImageReader reader = ImageIO.getImageReadersByFormatName("gif").next();
    reader.setInput(ImageIO.createImageInputStream(new ByteArrayInputStream(out.toByteArray())));
    return reader;
  }
}
