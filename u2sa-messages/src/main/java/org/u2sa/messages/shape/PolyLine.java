package org.u2sa.messages.shape;

import java.util.List;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;

/**
 * A band of some width in the x-y plane along points in order, as a painted line, a road or a
 * corridor; with a height, a wall. The points' own z says nothing: it is around the centre's. To
 * those who do not know it, it is a {@link Line}.
 */
public class PolyLine extends Line {
  private static final Schema<PolyLine> SCHEMA =
      Schema.of(PolyLine.class, PolyLine::new, Line.TYPE).since(3);
  private static final NumberField<PolyLine> WIDTH = SCHEMA.number("width", "m", 0.0, 0.0);
  private static final NumberField<PolyLine> HEIGHT = SCHEMA.number("height", "m", 0.0, 0.0);

  /** The schema. */
  public static final MessageType<PolyLine> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends PolyLine> type() {
    return TYPE;
  }

  /** Width [m], half of it to each side of the line, round at both ends; 0 until set. */
  public double width() {
    return require(WIDTH);
  }

  /** Sets {@link #width()}. */
  public PolyLine width(double value) {
    return put(WIDTH, value);
  }

  /** Height [m], half of it to each side of the centre; 0 until set: flat. */
  public double height() {
    return require(HEIGHT);
  }

  /** Sets {@link #height()}. */
  public PolyLine height(double value) {
    return put(HEIGHT, value);
  }

  @Override
  public PolyLine points(List<Point> value) {
    super.points(value);
    return this;
  }

  @Override
  public double distanceTo(Point from) {
    return Shapes.toBand(metric(), points(), Point.of(0.0, width(), height()), from);
  }
}
