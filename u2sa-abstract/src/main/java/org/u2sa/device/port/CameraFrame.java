package org.u2sa.device.port;

import java.util.Optional;

/**
 * One frame of a camera. Pixels stay in the capturing process: channels only carry compressed
 * images, as {@link org.u2sa.messages.CameraImage}. Compared by identity, to avoid comparing
 * pixels.
 *
 * @param measuredAtMicros start of exposure, or arrival of its bytes [µs of the run's clock]
 * @param width width [px], positive
 * @param height height [px], positive
 * @param pixels bytes, not copied; the caller must not modify them afterwards
 */
public record CameraFrame(
    long measuredAtMicros,
    int width,
    int height,
    PixelFormat format,
    byte[] pixels,
    Optional<Intrinsics> intrinsics)
    implements Device.Reading {
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

  /**
   * @throws IllegalArgumentException if the number of bytes does not match size and format
   */
  public CameraFrame {
    long bytes = (long) width * height * format.bytesPerPixel();
    boolean isWhole = format == PixelFormat.JPEG ? pixels.length > 0 : pixels.length == bytes;
    if (width < 1 || height < 1 || !isWhole) {
      throw new IllegalArgumentException(
          width + " x " + height + " pixels " + format + " are not " + pixels.length + " bytes");
    }
  }

  /** Creates a greyscale frame of a camera with unknown geometry. */
  public static CameraFrame grey(long measuredAtMicros, int width, int height, byte[] pixels) {
    return new CameraFrame(
        measuredAtMicros, width, height, PixelFormat.GREY8, pixels, Optional.empty());
  }

  @Override
  public boolean equals(Object other) {
    return this == other;
  }

  @Override
  public int hashCode() {
    return System.identityHashCode(this);
  }

  @Override
  public String toString() {
    return width + " x " + height + " " + format + " at " + measuredAtMicros + " µs";
  }
}
