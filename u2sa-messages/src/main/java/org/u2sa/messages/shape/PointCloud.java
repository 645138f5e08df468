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

  @Override
  public double distanceTo(Point from) {
    return Shapes.toNearest(metric(), points(), from);
  }

  @Override
  public PointCloud uid(String uid) {
    super.uid(uid);
    return this;
  }

  @Override
  public PointCloud objectType(String type) {
    super.objectType(type);
    return this;
  }

  @Override
  public PointCloud referenceFrame(ReferenceFrame frame) {
    super.referenceFrame(frame);
    return this;
  }

  @Override
  public PointCloud x(double x) {
    super.x(x);
    return this;
  }

  @Override
  public PointCloud y(double y) {
    super.y(y);
    return this;
  }

  @Override
  public PointCloud z(double z) {
    super.z(z);
    return this;
  }

  @Override
  public PointCloud level(ObjectLevel level) {
    super.level(level);
    return this;
  }
}
