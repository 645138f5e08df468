package org.u2sa.device.port;

import java.util.Optional;

/**
 * One frame of a camera. Pixels stay in the capturing process: channels only carry compressed
 * images, as {@link org.u2sa.messages.CameraImage}. Compared by identity, to avoid comparing
 * pixels.
 */
public final class CameraFrame implements Device.Reading {
  /** Pixel format of a frame. */
  public enum PixelFormat {
    /** One byte per pixel, row-major from the top: 0 black to 255 white. */
    GREY8(1),
    /** Three bytes per pixel, red, green and blue, row-major from the top. */
    RGB24(3),
    /** A JPEG file (ITU-T T.81). */
    JPEG(0);

    private final int bytesPerPixel;

    PixelFormat(int bytesPerPixel) {
      this.bytesPerPixel = bytesPerPixel;
    }

    /** Bytes per pixel; 0 for a compressed format. */
    public int bytesPerPixel() {
      return bytesPerPixel;
    }
  }

  /**
   * A pinhole camera's geometry (Hartley and Zisserman, Multiple View Geometry, 2nd ed., chapter
   * 6): a point at x right, y down, z ahead of the lens is imaged at column {@code focalX · x/z +
   * centreX}, row {@code focalY · y/z + centreY}. Without lens distortion.
   *
   * @param focalX focal length in pixel widths, positive
   * @param focalY focal length in pixel heights, positive
   * @param centreX column of the optical axis; 0 is the centre of the leftmost pixels
   * @param centreY row of the optical axis; 0 is the centre of the topmost pixels
   */
  public record Intrinsics(double focalX, double focalY, double centreX, double centreY) {
    /**
     * @throws IllegalArgumentException if a focal length is not positive
     */
    public Intrinsics {
      if (!(focalX > 0.0 && focalY > 0.0)) {
        throw new IllegalArgumentException(
            "focal length: " + focalX + ", " + focalY + " pixels are not both positive");
      }
    }
  }

  private final long measuredAtMicros;
  private final int width;
  private final int height;
  private final PixelFormat format;
  private final byte[] pixels;
  private final Optional<Intrinsics> intrinsics;

  /**
   * @param measuredAtMicros start of exposure, or arrival of its bytes [µs of the run's clock]
   * @param width width [px], positive
   * @param height height [px], positive
   * @param pixels bytes, not copied; the caller must not modify them afterwards
   * @throws IllegalArgumentException if the number of bytes does not match size and format
   */
  public CameraFrame(
      long measuredAtMicros,
      int width,
      int height,
      PixelFormat format,
      byte[] pixels,
      Optional<Intrinsics> intrinsics) {
    long bytes = (long) width * height * format.bytesPerPixel();
    boolean isWhole = format == PixelFormat.JPEG ? pixels.length > 0 : pixels.length == bytes;
    if (width < 1 || height < 1 || !isWhole) {
      throw new IllegalArgumentException(
          width + " x " + height + " pixels " + format + " are not " + pixels.length + " bytes");
    }
    this.measuredAtMicros = measuredAtMicros;
    this.width = width;
    this.height = height;
    this.format = format;
    this.pixels = pixels;
    this.intrinsics = intrinsics;
  }

  /** Creates a greyscale frame of a camera with unknown geometry. */
  public static CameraFrame grey(long measuredAtMicros, int width, int height, byte[] pixels) {
    return new CameraFrame(
        measuredAtMicros, width, height, PixelFormat.GREY8, pixels, Optional.empty());
  }

  @Override
  public long measuredAtMicros() {
    return measuredAtMicros;
  }

  /** Width [px]. */
  public int width() {
    return width;
  }

  /** Height [px]. */
  public int height() {
    return height;
  }

  /** Format of {@link #pixels}. */
  public PixelFormat format() {
    return format;
  }

  /** The image data; not to be modified. */
  public byte[] pixels() {
    return pixels;
  }

  /** The camera's geometry; empty if unknown. */
  public Optional<Intrinsics> intrinsics() {
    return intrinsics;
  }

  @Override
  public String toString() {
    return width + " x " + height + " " + format + " at " + measuredAtMicros + " µs";
  }
}
