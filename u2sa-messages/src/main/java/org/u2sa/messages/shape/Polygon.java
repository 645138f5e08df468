package org.u2sa.messages.shape;

import java.util.List;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.ValueField;

/**
 * A polygon in the x-y plane, such as a building, a field or a no-fly zone; with a height, an
 * upright prism. The corners' own z is ignored; the prism is centred on the object's z.
 */
public class Polygon extends ShapeSetters<Polygon> {
  private static final Schema<Polygon> SCHEMA =
      Schema.of(Polygon.class, Polygon::new, ShapeDescription.TYPE).since(3);
  private static final ValueField<Polygon, List<Point>> POINTS = SCHEMA.points("points", "m");
  private static final NumberField<Polygon> HEIGHT = SCHEMA.number("height", "m", 0.0, 0.0);

  public static final MessageType<Polygon> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends Polygon> type() {
    return TYPE;
  }

  /**
   * The corners in order, either way round, in the message's frame, not relative to the centre; the
   * last is joined to the first. Even-odd rule for crossing edges: a point is inside if a ray from
   * it crosses an odd number of edges.
   */
  public List<Point> points() {
    return require(POINTS);
  }

  public Polygon points(List<Point> value) {
    return put(POINTS, value);
  }

  /** Height [m], centred on z; defaults to 0, flat. */
  public double height() {
    return require(HEIGHT);
  }

  public Polygon height(double value) {
    return put(HEIGHT, value);
  }

  @Override
  public double distanceTo(Point from) {
    return Shapes.toPolygon(metric(), points(), height(), from);
  }
}
