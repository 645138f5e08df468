package org.u2sa.vision.camera;

import java.util.Optional;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.messages.CameraImage;
import org.u2sa.messages.cbor.ByteString;
import org.u2sa.vision.picture.JpegEncoder;

/** Periodically turns camera frames into messages for display. Not thread-safe. */
final class CameraImages {
  private static final int QUALITY = 80;
  private static final double MICROS_PER_S = 1e6;

  private final JpegEncoder encoder = new JpegEncoder(QUALITY);
  private final String sensorName;
  private final long everyMicros;
  private long lastMicros; // of the previous frame, published or not
  private long dueMicros; // time of the next one; 0 before the first

  /**
   * @param everyS average period [s], as far as the camera's rate allows
   */
  CameraImages(String sensorName, double everyS) {
    this.sensorName = sensorName;
    everyMicros = Math.round(everyS * MICROS_PER_S);
  }

  /**
   * Returns the frame as a JPEG message with the frame's time, if one is due.
   *
   * @throws IllegalArgumentException if the image is too large for a message
   */
  Optional<CameraImage> of(CameraFrame frame) {
    long micros = frame.measuredAtMicros();
    boolean isSetBack = micros < lastMicros; // clock was set back
    lastMicros = micros;
    if (micros < dueMicros && !isSetBack) {
      return Optional.empty();
    }
    boolean keepsPace = !isSetBack && micros < dueMicros + everyMicros;
    dueMicros = (keepsPace ? dueMicros : micros) + everyMicros;
    CameraImage image =
        new CameraImage()
            .sensorName(sensorName)
            .format(CameraImage.JPEG)
            .size(frame.width(), frame.height())
            .data(ByteString.copyOf(encoder.encode(frame)));
    image.timestamp(micros);
    return Optional.of(image);
  }
}
