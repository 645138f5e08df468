package org.u2sa.vision.camera;

import java.util.Optional;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.messages.CameraImage;
import org.u2sa.messages.cbor.ByteString;
import org.u2sa.vision.picture.JpegEncoder;

/** Periodically turns camera frames into messages for display. Not thread-safe. */
public final class CameraImages {
  private static final int CHANNELS = 3;
  private static final int QUALITY = 80;
  private static final double MICROS_PER_S = 1e6;

  private final JpegEncoder encoder = new JpegEncoder(QUALITY);
  private final String sensorName;
  private final long everyMicros;
  private final int shrink;
  private long lastMicros; // of the previous frame, published or not
  private long dueMicros; // time of the next one; 0 before the first

  /**
   * @param everyS average period [s], as far as the camera's rate allows
   */
  CameraImages(String sensorName, double everyS) {
    this(sensorName, everyS, 1);
  }

  /**
   * @param everyS average interval [s], as the camera's rate permits
   * @param shrink pixels merged into one along each side; RGB24 only
   */
  public CameraImages(String sensorName, double everyS, int shrink) {
    this.sensorName = sensorName;
    this.shrink = shrink;
    everyMicros = Math.round(everyS * MICROS_PER_S);
  }

  /**
   * Returns the frame as a JPEG message with the frame's time, if one is due.
   *
   * @throws IllegalArgumentException if the image is too large for a message
   */
  public Optional<CameraImage> of(CameraFrame frame) {
    long micros = frame.measuredAtMicros();
    boolean isSetBack = micros < lastMicros; // clock was set back
    lastMicros = micros;
    if (micros < dueMicros && !isSetBack) {
      return Optional.empty();
    }
    boolean keepsPace = !isSetBack && micros < dueMicros + everyMicros;
    dueMicros = (keepsPace ? dueMicros : micros) + everyMicros;
    CameraFrame shown = shrunk(frame);
    CameraImage image =
        new CameraImage()
            .sensorName(sensorName)
            .format(CameraImage.JPEG)
            .size(shown.width(), shown.height())
            .data(ByteString.copyOf(encoder.encode(shown)));
    image.timestamp(micros);
    return Optional.of(image);
  }

  private CameraFrame shrunk(CameraFrame frame) {
    int width = frame.width() / shrink;
    int height = frame.height() / shrink;
    if (shrink == 1
        || frame.format() != CameraFrame.PixelFormat.RGB24
        || width == 0
        || height == 0) {
      return frame;
    }
    byte[] pixels = new byte[CHANNELS * width * height];
    for (int i = 0; i < pixels.length; i++) {
      int column = i / CHANNELS % width * shrink;
      int row = i / CHANNELS / width * shrink;
      int sum = shrink * shrink / 2;
      for (int k = 0; k < shrink * shrink; k++) {
        int at = (row + k / shrink) * frame.width() + column + k % shrink;
        sum += frame.pixels()[CHANNELS * at + i % CHANNELS] & 0xff;
      }
      pixels[i] = (byte) (sum / (shrink * shrink));
    }
    return new CameraFrame(
        frame.measuredAtMicros(), width, height, frame.format(), pixels, Optional.empty());
  }
}
