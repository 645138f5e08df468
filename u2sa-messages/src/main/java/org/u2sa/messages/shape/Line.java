package org.u2sa.messages.shape;

import java.util.List;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.ValueField;

/** A polyline, such as a fence, a kerb or a shoreline. */
public class Line extends ShapeSetters<Line> {
  private static final Schema<Line> SCHEMA =
      Schema.of(Line.class, Line::new, ShapeDescription.TYPE);
  private static final ValueField<Line, List<Point>> POINTS = SCHEMA.points("points", "m");

  public static final MessageType<Line> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends Line> type() {
    return TYPE;
  }

  /** The points in order, in the message's frame, not relative to the centre. */
  public List<Point> points() {
    return require(POINTS);
  }

  public Line points(List<Point> value) {
    return put(POINTS, value);
  }

  @Override
  public double distanceTo(Point from) {
    return Shapes.toPolyline(metric(), points(), from);
  }
}
