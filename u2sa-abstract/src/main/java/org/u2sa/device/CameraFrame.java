package org.u2sa.device;

import java.util.Optional;

/**
 * One picture of a camera. Pixels stay in the process that took them: a channel carries only what
 * is compressed, as {@link org.u2sa.messages.CameraImage}. Equal only to itself, so that no pixels
 * are compared.
 */
public final class CameraFrame implements Device.Reading {
  /** What the bytes of a frame are. */
  public enum PixelFormat {
    /** One byte a pixel, row by row from the top: 0 black to 255 white. */
    GREY8(1),
    /** Three bytes a pixel, red, green and blue, row by row from the top. */
    RGB24(3),
    /** A JPEG file (ITU-T T.81). */
    JPEG(0);

    private final int bytesPerPixel;

    PixelFormat(int bytesPerPixel) {
      this.bytesPerPixel = bytesPerPixel;
    }

    /** Bytes of each pixel; 0 for a compressed format. */
    public int bytesPerPixel() {
      return bytesPerPixel;
    }
  }

  /**
   * A pinhole camera's geometry (Hartley and Zisserman, Multiple View Geometry, 2nd ed., chapter
   * 6): a point at x right, y down, z ahead of the lens is seen at column {@code focalX · x/z +
   * centreX}, row {@code focalY · y/z + centreY}. Lens distortion is not part of it.
   *
   * @param focalX focal length in widths of a pixel, positive
   * @param focalY focal length in heights of a pixel, positive
   * @param centreX column of the optical axis; 0 is the middle of the leftmost pixels
   * @param centreY row of the optical axis; 0 is the middle of the topmost pixels
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
   * @param measuredAtMicros when its exposure began, or its bytes arrived [µs of the run's clock]
   * @param width pixels of a row, positive
   * @param height rows, positive
   * @param pixels not to be changed any more: they are not copied
   * @throws IllegalArgumentException if the bytes are not as many as size and format say
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

  /** A frame in shades of grey, of a camera whose geometry is unknown. */
  public static CameraFrame grey(long measuredAtMicros, int width, int height, byte[] pixels) {
    return new CameraFrame(
        measuredAtMicros, width, height, PixelFormat.GREY8, pixels, Optional.empty());
  }

  @Override
  public long measuredAtMicros() {
    return measuredAtMicros;
  }

  /** Pixels of a row. */
  public int width() {
    return width;
  }

  /** Number of rows. */
  public int height() {
    return height;
  }

  /** What {@link #pixels} are. */
  public PixelFormat format() {
    return format;
  }

  /** The picture itself; not to be changed. */
  public byte[] pixels() {
    return pixels;
  }

  /** The camera's geometry; empty if it is unknown. */
  public Optional<Intrinsics> intrinsics() {
    return intrinsics;
  }

  @Override
  public String toString() {
    return width + " x " + height + " " + format + " at " + measuredAtMicros + " µs";
  }
}
