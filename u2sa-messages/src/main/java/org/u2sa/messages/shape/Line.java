package org.u2sa.messages.shape;

import java.util.List;
import org.u2sa.messages.ObjectLevel;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.ValueField;

/** A line through points in order, as a fence, a kerb or a shore. */
public class Line extends ShapeDescription {
  private static final Schema<Line> SCHEMA =
      Schema.of("Line", Line.class, Line::new, ShapeDescription.TYPE);
  private static final ValueField<Line, List<Point>> POINTS = SCHEMA.points("points", "m");

  /** The schema. */
  public static final MessageType<Line> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends Line> type() {
    return TYPE;
  }

  /** The points in order, in the message's frame: not relative to the centre. */
  public List<Point> points() {
    return require(POINTS);
  }

  /** Sets {@link #points()}. */
  public Line points(List<Point> value) {
    put(POINTS, value);
    return this;
  }

  @Override
  public double distanceTo(Point from) {
    return Shapes.toPolyline(metric(), points(), from);
  }

  @Override
  public Line uid(String uid) {
    super.uid(uid);
    return this;
  }

  @Override
  public Line objectType(String type) {
    super.objectType(type);
    return this;
  }

  @Override
  public Line referenceFrame(ReferenceFrame frame) {
    super.referenceFrame(frame);
    return this;
  }

  @Override
  public Line x(double x) {
    super.x(x);
    return this;
  }

  @Override
  public Line y(double y) {
    super.y(y);
    return this;
  }

  @Override
  public Line z(double z) {
    super.z(z);
    return this;
  }

  @Override
  public Line level(ObjectLevel level) {
    super.level(level);
    return this;
  }
}
