package org.u2sa.messages.shape;

import java.util.List;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;

/**
 * A band of some width along a polyline in the x-y plane, such as a painted line, a road or a
 * corridor; with a height, a wall. The points' own z is ignored; the height is centred on the
 * object's z. Readers that do not know this class see a {@link Line}.
 */
public class PolyLine extends Line {
  private static final Schema<PolyLine> SCHEMA =
      Schema.of(PolyLine.class, PolyLine::new, Line.TYPE).since(3);
  private static final NumberField<PolyLine> WIDTH = SCHEMA.number("width", "m", 0.0, 0.0);
  private static final NumberField<PolyLine> HEIGHT = SCHEMA.number("height", "m", 0.0, 0.0);

  public static final MessageType<PolyLine> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends PolyLine> type() {
    return TYPE;
  }

  /** Width [m], centred on the line, with rounded ends; defaults to 0. */
  public double width() {
    return require(WIDTH);
  }

  public PolyLine width(double value) {
    return put(WIDTH, value);
  }

  /** Height [m], centred on z; defaults to 0, flat. */
  public double height() {
    return require(HEIGHT);
  }

  public PolyLine height(double value) {
    return put(HEIGHT, value);
  }

  @Override
  public PolyLine points(List<Point> value) {
    return (PolyLine) super.points(value);
  }

  @Override
  public double distanceTo(Point from) {
    return Shapes.toBand(metric(), points(), Point.of(0.0, width(), height()), from);
  }
}
