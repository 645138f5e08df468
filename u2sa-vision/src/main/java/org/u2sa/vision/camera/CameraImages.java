package org.u2sa.vision.camera;

import java.util.Optional;
import org.u2sa.device.CameraFrame;
import org.u2sa.messages.CameraImage;
import org.u2sa.messages.schema.ByteString;
import org.u2sa.vision.picture.JpegEncoder;

/** Makes a message of a camera's picture now and then, for people to look at. For one thread. */
final class CameraImages {
  private static final int QUALITY = 80;
  private static final double MICROS_PER_S = 1e6;

  private final JpegEncoder encoder = new JpegEncoder(QUALITY);
  private final String sensorName;
  private final long everyMicros;
  private long lastMicros; // of the picture before, published or not
  private long dueMicros; // when the next one is; 0 before the first

  /**
   * @param everyS from one picture to the next [s], on average if the camera can
   */
  CameraImages(String sensorName, double everyS) {
    this.sensorName = sensorName;
    everyMicros = Math.round(everyS * MICROS_PER_S);
  }

  /**
   * The picture as a message if it is time for one, JPEG and of the picture's time.
   *
   * @throws IllegalArgumentException if the picture is too large for a message
   */
  Optional<CameraImage> of(CameraFrame frame) {
    long micros = frame.measuredAtMicros();
    boolean isSetBack = micros < lastMicros; // the clock was
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
