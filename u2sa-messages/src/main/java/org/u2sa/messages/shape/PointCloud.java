package org.u2sa.messages.shape;

import java.util.List;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectLevel;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.ValueField;

/**
 * An object measured as at least one point (thesis 3.2.3.6, figure 10), in the message's own frame.
 *
 * <p>A cloud whose UID is the name of its sensor is a scan: everything that the sensor sees at that
 * time, possibly nothing.
 */
public class PointCloud extends ObjectDescription {
  private static final Schema<PointCloud> SCHEMA =
      Schema.of(PointCloud.class, PointCloud::new, ObjectDescription.TYPE);
  private static final ValueField<PointCloud, List<Point>> POINTS = SCHEMA.points("points", "m");

  public static final MessageType<PointCloud> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends PointCloud> type() {
    return TYPE;
  }

  /** The points, in the message's frame: not relative to the centre. */
  public List<Point> points() {
    return require(POINTS);
  }

  public PointCloud points(List<Point> value) {
    return put(POINTS, value);
  }

  /** Whether it is everything that its sensor sees, rather than one object among others. */
  public boolean isScan() {
    return !sensorName().isEmpty() && sensorName().equals(uid());
  }

  @Override
  public double distanceTo(Point from) {
    return Shapes.toNearest(metric(), points(), from);
  }

  @Override
  public PointCloud uid(String uid) {
    return (PointCloud) super.uid(uid);
  }

  @Override
  public PointCloud objectType(String type) {
    return (PointCloud) super.objectType(type);
  }

  @Override
  public PointCloud referenceFrame(ReferenceFrame frame) {
    return (PointCloud) super.referenceFrame(frame);
  }

  @Override
  public PointCloud x(double x) {
    return (PointCloud) super.x(x);
  }

  @Override
  public PointCloud y(double y) {
    return (PointCloud) super.y(y);
  }

  @Override
  public PointCloud z(double z) {
    return (PointCloud) super.z(z);
  }

  @Override
  public PointCloud level(ObjectLevel level) {
    return (PointCloud) super.level(level);
  }
}
