package org.u2sa.testkit;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.ImageOutputStream;

/** Progressive JPEG files of as many scans as a test wants. */
public final class ProgressiveJpeg {
  private ProgressiveJpeg() {}

  /** The image, with its last scan repeated. */
  public static byte[] of(BufferedImage image, int repetitions) throws IOException {
    ImageWriter writer = ImageIO.getImageWritersByFormatName("jpeg").next();
    ImageWriteParam way = writer.getDefaultWriteParam();
    way.setProgressiveMode(ImageWriteParam.MODE_DEFAULT);
    ByteArrayOutputStream file = new ByteArrayOutputStream();
    try (ImageOutputStream out = ImageIO.createImageOutputStream(file)) {
      writer.setOutput(out);
      writer.write(null, new IIOImage(image, null, null), way);
    }
    writer.dispose();
    byte[] whole = file.toByteArray();
    int end = whole.length - 2; // of the last scan
    int scan = end - 1;
    while (whole[scan] != (byte) 0xFF || whole[scan + 1] != (byte) 0xDA) {
      scan--;
    }
    ByteArrayOutputStream longer = new ByteArrayOutputStream();
    longer.write(whole, 0, end);
    for (int i = 0; i < repetitions; i++) {
      longer.write(whole, scan, end - scan);
    }
    longer.write(whole, end, 2);
    return longer.toByteArray();
  }
}
