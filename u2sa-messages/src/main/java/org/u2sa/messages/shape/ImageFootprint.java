package org.u2sa.messages.shape;

import java.util.List;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.ValueField;

/**
 * The ground that one image shows (thesis 4.4.1.3): its outline, with the number of the image, the
 * ground resolution and the angle. The timestamp is the time of exposure.
 */
public class ImageFootprint extends Polygon {
  private static final Schema<ImageFootprint> SCHEMA =
      Schema.of(ImageFootprint.class, ImageFootprint::new, Polygon.TYPE).since(3);
  private static final ValueField<ImageFootprint, Long> IMAGE = SCHEMA.count("image", "");
  private static final NumberField<ImageFootprint> RESOLUTION =
      SCHEMA.requiredNumber("resolution", "m", 0.0, Double.POSITIVE_INFINITY);
  private static final NumberField<ImageFootprint> ANGLE = SCHEMA.number("angle", "rad", 0.0, 0.0);

  public static final MessageType<ImageFootprint> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends ImageFootprint> type() {
    return TYPE;
  }

  /** Number of the image since the camera's start. */
  public long image() {
    return get(IMAGE);
  }

  public ImageFootprint image(long number) {
    return put(IMAGE, number);
  }

  /** Coarsest ground resolution within the image [m per pixel]. */
  public double resolution() {
    return require(RESOLUTION);
  }

  public ImageFootprint resolution(double metres) {
    return put(RESOLUTION, metres);
  }

  /** Largest angle between a ray of the image and the vertical [rad]. */
  public double angle() {
    return require(ANGLE);
  }

  public ImageFootprint angle(double rad) {
    return put(ANGLE, rad);
  }

  @Override
  public ImageFootprint points(List<Point> value) {
    return (ImageFootprint) super.points(value);
  }
}
