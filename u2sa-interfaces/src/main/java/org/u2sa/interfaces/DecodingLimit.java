package org.u2sa.interfaces;

import java.io.IOException;
import java.util.Optional;

/**
 * Limit of the work that an image from outside may cause: a small progressive JPEG may have
 * thousands of scans, each of all pixels.
 *
 * @param maxPixels of an image
 * @param maxScanned pixels times scans
 */
public record DecodingLimit(long maxPixels, long maxScanned) {
  /** Pixels times scans of an image that somebody waits for: a second or two of decoding. */
  public static final long MAX_SCANNED_AT_LEISURE = 500_000_000L;

  private static final int BLOCK_BYTES = 1 << 16;
  private static final int HEAD_BYTES = 34; // up to a BMP's compression
  private static final int COMPRESSION = 30; // offset in a BMP (BITMAPINFOHEADER)
  private static final int JPEG_IN_BMP = 4;
  private static final int PNG_IN_BMP = 5;
  private static final int MARKER = 0xFF;
  private static final int START_OF_SCAN = 0xDA;

  /** Reads as {@link java.io.InputStream#read(byte[])}. */
  @FunctionalInterface
  public interface Source {
    int read(byte[] to) throws IOException;
  }

  /**
   * Why an image is refused; empty if it is not.
   *
   * @param scans of a JPEG; 1 for other images
   */
  public Optional<String> problem(int width, int height, long scans) {
    long pixels = (long) width * height;
    if (pixels <= maxPixels && pixels * scans <= maxScanned) {
      return Optional.empty();
    }
    return Optional.of(
        String.format(
            "an image of %d by %d pixels in %d scans; expected at most %d pixels, times scans at most %d",
            width, height, scans, maxPixels, maxScanned));
  }

  /**
   * As {@link #problem}.
   *
   * @throws IOException if there is one
   */
  public void require(int width, int height, long scans) throws IOException {
    Optional<String> problem = problem(width, height, scans);
    if (problem.isPresent()) {
      throw new IOException(problem.get());
    }
  }

  /**
   * Scans of a JPEG; 1 for a PNG, BMP or GIF file. In a JPEG, compressed data contain no such
   * marker (ITU-T T.81, B.1.1.5).
   *
   * @param file from its beginning; read to its end if it is a JPEG
   * @throws IOException if it is another kind of file: TIFF files and some BMP files contain JPEG
   *     images of any size
   */
  public static long scans(Source file) throws IOException {
    byte[] head = new byte[HEAD_BYTES];
    byte[] block = new byte[BLOCK_BYTES];
    long bytes = 0;
    long scans = 0;
    int before = 0;
    for (int length = file.read(block); length > 0; length = file.read(block)) {
      for (int i = 0; i < length; i++) {
        if (bytes < HEAD_BYTES) {
          head[(int) bytes] = block[i];
        }
        bytes++;
        int each = block[i] & 0xFF;
        scans += before == MARKER && each == START_OF_SCAN ? 1 : 0;
        before = each;
      }
      if (bytes >= HEAD_BYTES && !begins(head, "\u00FF\u00D8")) {
        break;
      }
    }
    if (begins(head, "\u00FF\u00D8")) {
      return Math.max(1, scans);
    }
    boolean isPlainBitmap =
        begins(head, "BM") && head[COMPRESSION] != JPEG_IN_BMP && head[COMPRESSION] != PNG_IN_BMP;
    if (!isPlainBitmap && !begins(head, "\u0089PNG") && !begins(head, "GIF8")) {
      throw new IOException("is not a PNG, JPEG, BMP or GIF picture");
    }
    return 1;
  }

  private static boolean begins(byte[] head, String magic) {
    for (int i = 0; i < magic.length(); i++) {
      if ((head[i] & 0xFF) != magic.charAt(i)) {
        return false;
      }
    }
    return true;
  }
}
