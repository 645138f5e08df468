package org.u2sa.report.picture;

import java.awt.image.BufferedImage;
import java.awt.image.DataBuffer;
import java.awt.image.DataBufferByte;
import java.awt.image.IndexColorModel;
import java.util.Arrays;

/**
 * Reduces a drawing to the 256 colours that cover most of it; other pixels get the nearest of them.
 * Drawings have few colours, so this looks the same as the palette that the JDK's GIF writer would
 * build, and takes a fraction of its time.
 */
final class IndexedColours {
  private static final int COLOURS = 256;
  private static final int BITS = 5; // of each channel: colours that agree in these share an entry
  private static final int GROUPS = 1 << 3 * BITS;
  private static final int UNKNOWN = -1;

  private final int[] counts = new int[GROUPS];
  private final int[] exact = new int[GROUPS]; // a colour of each group
  private final int[] indices = new int[GROUPS];
  private final int[] palette;

  private IndexedColours(int[] pixels) {
    for (int pixel : pixels) {
      int group = group(pixel);
      counts[group]++;
      exact[group] = pixel;
    }
    long[] frequent = new long[GROUPS];
    int used = 0;
    for (int group = 0; group < GROUPS; group++) {
      if (counts[group] > 0) {
        frequent[used++] = -((long) counts[group] << 3 * BITS) + group;
      }
    }
    Arrays.sort(frequent, 0, used);
    palette = new int[Math.min(used, COLOURS)];
    Arrays.fill(indices, UNKNOWN);
    for (int i = 0; i < palette.length; i++) {
      int group = (int) (frequent[i] & GROUPS - 1);
      palette[i] = exact[group];
      indices[group] = i;
    }
  }

  /** Copies an image with at most 256 colours. */
  static BufferedImage of(BufferedImage image) {
    int width = image.getWidth();
    int height = image.getHeight();
    int[] pixels = image.getRGB(0, 0, width, height, null, 0, width);
    IndexedColours colours = new IndexedColours(pixels);
    int[] table = Arrays.copyOf(colours.palette, COLOURS);
    IndexColorModel model =
        new IndexColorModel(8, COLOURS, table, 0, false, -1, DataBuffer.TYPE_BYTE);
    BufferedImage indexed =
        new BufferedImage(width, height, BufferedImage.TYPE_BYTE_INDEXED, model);
    byte[] cells = ((DataBufferByte) indexed.getRaster().getDataBuffer()).getData();
    for (int i = 0; i < pixels.length; i++) {
      cells[i] = (byte) colours.index(pixels[i]);
    }
    return indexed;
  }

  private static int group(int pixel) {
    int drop = 8 - BITS;
    return (pixel >> 16 + drop & 31) << 2 * BITS
        | (pixel >> 8 + drop & 31) << BITS
        | pixel >> drop & 31;
  }

  private int index(int pixel) {
    int group = group(pixel);
    if (indices[group] == UNKNOWN) {
      indices[group] = nearest(exact[group]);
    }
    return indices[group];
  }

  private int nearest(int pixel) {
    int best = 0;
    int least = Integer.MAX_VALUE;
    for (int i = 0; i < palette.length; i++) {
      int red = (pixel >> 16 & 0xFF) - (palette[i] >> 16 & 0xFF);
      int green = (pixel >> 8 & 0xFF) - (palette[i] >> 8 & 0xFF);
      int blue = (pixel & 0xFF) - (palette[i] & 0xFF);
      int distance = red * red + green * green + blue * blue;
      if (distance < least) {
        least = distance;
        best = i;
      }
    }
    return best;
  }
}
