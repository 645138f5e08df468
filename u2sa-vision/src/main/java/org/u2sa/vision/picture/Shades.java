package org.u2sa.vision.picture;

import org.u2sa.device.port.CameraFrame;
import org.u2sa.device.port.CameraFrame.PixelFormat;

/**
 * An image as two log-scale channels, so that a difference is a brightness ratio independent of
 * illumination: brightness of the darkest colour (white paint is bright in all, grass is dark in
 * blue), and tint (brightest over darkest colour). One octave is {@link #OCTAVE} steps. Reuses its
 * buffers: holds one image at a time.
 */
public final class Shades {
  /** Steps per doubling of brightness. */
  public static final double OCTAVE = 50.0;

  private static final double DARK = 8.0; // offset that suppresses noise in dark pixels

  private final byte[] log = new byte[256];
  private byte[] white = new byte[0];
  private byte[] tint = new byte[0];
  private int width;
  private int height;

  public Shades() {
    for (int i = 0; i < log.length; i++) {
      log[i] = (byte) Math.round(OCTAVE * Math.log((i + DARK) / DARK) / Math.log(2.0));
    }
  }

  /**
   * Computes the channels of an image.
   *
   * @throws IllegalArgumentException if it is still JPEG-encoded
   */
  public void take(CameraFrame frame) {
    if (frame.format() == PixelFormat.JPEG) {
      throw new IllegalArgumentException("a JPEG picture has no pixels yet");
    }
    width = frame.width();
    height = frame.height();
    int count = width * height;
    if (white.length < count) {
      white = new byte[count];
      tint = new byte[count];
    }
    if (frame.format() == PixelFormat.GREY8) {
      byte[] grey = frame.pixels();
      for (int i = 0; i < count; i++) {
        white[i] = log[grey[i] & 0xFF];
        tint[i] = 0;
      }
    } else {
      takeColours(frame.pixels(), count);
    }
  }

  private void takeColours(byte[] rgb, int count) {
    for (int i = 0, at = 0; i < count; i++, at += 3) {
      int red = rgb[at] & 0xFF;
      int green = rgb[at + 1] & 0xFF;
      int blue = rgb[at + 2] & 0xFF;
      int least = Math.min(red, Math.min(green, blue));
      int most = Math.max(red, Math.max(green, blue));
      white[i] = log[least];
      tint[i] = (byte) ((log[most] & 0xFF) - (log[least] & 0xFF));
    }
  }

  /** Width [px]. */
  public int width() {
    return width;
  }

  /** Height [px]. */
  public int height() {
    return height;
  }

  /** Shade of the darkest colour, unsigned, row-major; may be longer than the image. */
  public byte[] white() {
    return white;
  }

  /** Shade of brightest over darkest colour, unsigned; 0 is grey. */
  public byte[] tint() {
    return tint;
  }
}
