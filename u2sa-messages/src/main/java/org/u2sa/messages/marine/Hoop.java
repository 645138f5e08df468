package org.u2sa.messages.marine;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.messages.PointConversion;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.ValueField;
import org.u2sa.messages.shape.ShapeDescription;

/**
 * A ring around the centre (thesis 4.2.1.3, 4.3): upright, its normal towards psi, or lying flat,
 * such as the floating ring that RoboSub surfaces in. Only the ring itself is solid.
 */
public class Hoop extends ShapeDescription implements Coloured {
  private static final Schema<Hoop> SCHEMA =
      Schema.of(Hoop.class, Hoop::new, ShapeDescription.TYPE).since(3);
  private static final NumberField<Hoop> RADIUS = SCHEMA.number("radius", "m", 0.0, 0.0);
  private static final NumberField<Hoop> THICKNESS = SCHEMA.number("thickness", "m", 0.0, 0.0);
  private static final NumberField<Hoop> PSI = SCHEMA.number("psi", "rad", 0.0);
  private static final ValueField<Hoop, Boolean> LYING = SCHEMA.flag("lying");
  private static final ValueField<Hoop, Colour> COLOUR =
      SCHEMA.optionalChoice("colour", Colour.class);

  public static final MessageType<Hoop> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends Hoop> type() {
    return TYPE;
  }

  /** Radius of the ring's centre line [m]. */
  public double radius() {
    return require(RADIUS);
  }

  public Hoop radius(double value) {
    return put(RADIUS, value);
  }

  /** Diameter of the tube [m]. */
  public double thickness() {
    return require(THICKNESS);
  }

  public Hoop thickness(double value) {
    return put(THICKNESS, value);
  }

  /**
   * Direction of the normal of an upright hoop [rad], measured as the frame measures psi; the
   * opposite direction describes the same hoop.
   */
  public double psi() {
    return require(PSI);
  }

  public Hoop psi(double value) {
    return put(PSI, value);
  }

  /** Whether the hoop lies flat, with a vertical normal; psi then has no meaning. */
  public boolean lying() {
    return require(LYING);
  }

  public Hoop lying(boolean value) {
    return put(LYING, value);
  }

  /** The colour; empty if unknown. */
  @Override
  public Optional<Colour> colour() {
    return Optional.ofNullable(get(COLOUR));
  }

  public Hoop colour(Colour colour) {
    return put(COLOUR, colour);
  }

  /**
   * Points of the centre line, evenly spaced, in the message's frame; the last one is the first.
   *
   * @param count of different points, at least 3
   */
  public List<Point> outline(int count) {
    Point across = across();
    List<Point> points = new ArrayList<>(count + 1);
    for (int i = 0; i <= count; i++) {
      double angle = 2.0 * Math.PI * (i % count) / count;
      double a = radius() * Math.cos(angle);
      double b = radius() * Math.sin(angle);
      Point up = lying() ? Point.of(-across.y(), across.x(), 0.0) : Point.of(0.0, 0.0, 1.0);
      points.add(metric().point(across.times(a).plus(up.times(b))));
    }
    return points;
  }

  /** Horizontal unit vector in the plane of the hoop, in metric axes. */
  private Point across() {
    double along = referenceFrame().isEarth() ? Math.PI / 2.0 - psi() : psi();
    return Point.of(-Math.sin(along), Math.cos(along), 0.0);
  }

  @Override
  protected void move(PointConversion conversion) {
    psi(conversion.heading(center(), psi()));
    super.move(conversion);
  }

  @Override
  public double distanceTo(Point from) {
    Point p = metres(from);
    Point across = across();
    double a = p.x() * across.x() + p.y() * across.y();
    double ahead = p.x() * across.y() - p.y() * across.x();
    double inPlane = lying() ? Math.hypot(p.x(), p.y()) : Math.hypot(a, p.z());
    double off = lying() ? p.z() : ahead;
    return Math.max(0.0, Math.hypot(inPlane - radius(), off) - thickness() / 2.0);
  }
}
