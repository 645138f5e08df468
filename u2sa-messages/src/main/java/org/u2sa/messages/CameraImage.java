package org.u2sa.messages;

import org.u2sa.messages.cbor.ByteString;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/**
 * A compressed camera image, meant for people: in recordings and on screens.
 *
 * <p>The timestamp is the time of exposure.
 */
public final class CameraImage extends U2SAData {
  /** The {@link #format()} of JPEG images. */
  public static final String JPEG = "jpeg";

  private static final long MAX_SIDE_PX = 65_535; // limit of JPEG (ITU-T T.81, B.2.2)

  private static final Schema<CameraImage> SCHEMA =
      Schema.of(CameraImage.class, CameraImage::new, U2SAData.TYPE).since(3);
  private static final ValueField<CameraImage, String> SENSOR_NAME =
      SCHEMA.requiredName("sensorName");
  private static final ValueField<CameraImage, String> FORMAT = SCHEMA.requiredName("format");
  private static final ValueField<CameraImage, Long> WIDTH = SCHEMA.count("width", "px");
  private static final ValueField<CameraImage, Long> HEIGHT = SCHEMA.count("height", "px");
  private static final ValueField<CameraImage, ByteString> DATA = SCHEMA.requiredBytes("data");

  public static final MessageType<CameraImage> TYPE = SCHEMA.build();

  @Override
  public MessageType<CameraImage> type() {
    return TYPE;
  }

  /** Name of the camera, which distinguishes several cameras. */
  public String sensorName() {
    return require(SENSOR_NAME);
  }

  public CameraImage sensorName(String value) {
    return put(SENSOR_NAME, value);
  }

  /** Compression format, by its media subtype: "jpeg", "png" or "webp". */
  public String format() {
    return require(FORMAT);
  }

  public CameraImage format(String value) {
    return put(FORMAT, value);
  }

  /** Image width [px]; 0 if unknown to the writer. */
  public long width() {
    return get(WIDTH);
  }

  /** Image height [px]; 0 if unknown to the writer. */
  public long height() {
    return get(HEIGHT);
  }

  /**
   * Sets {@link #width()} and {@link #height()}.
   *
   * @throws IllegalArgumentException if one is less than 1
   */
  public CameraImage size(int widthPx, int heightPx) {
    if (widthPx < 1 || heightPx < 1) {
      throw new IllegalArgumentException(
          "CameraImage: expected a size of at least 1 x 1 px, not " + widthPx + " x " + heightPx);
    }
    put(WIDTH, (long) widthPx);
    return put(HEIGHT, (long) heightPx);
  }

  @Override
  protected void requireConsistent() {
    if (width() < 0 || width() > MAX_SIDE_PX || height() < 0 || height() > MAX_SIDE_PX) {
      throw new IllegalStateException(
          String.format(
              "CameraImage: a size of %s x %s px; expected 0…%s along each side",
              width(), height(), MAX_SIDE_PX));
    }
  }

  /** The compressed image: a complete file in its {@link #format()}. */
  public ByteString data() {
    return require(DATA);
  }

  public CameraImage data(ByteString value) {
    return put(DATA, value);
  }
}
