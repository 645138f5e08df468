package org.u2sa.messages.marine;

import java.util.List;
import java.util.Optional;
import org.u2sa.messages.PointConversion;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.ValueField;
import org.u2sa.messages.shape.Box;
import org.u2sa.messages.shape.ShapeDescription;

/**
 * A floating dock with one bay: a back wall and two fingers, open towards psi (thesis 4.2.1.3). The
 * centre is that of the whole rectangle; a vessel that docks bow first heads opposite to psi. The
 * bay is free water; only the walls are solid.
 */
public class Dock extends ShapeDescription implements Coloured {
  private static final Schema<Dock> SCHEMA =
      Schema.of(Dock.class, Dock::new, ShapeDescription.TYPE).since(3);
  private static final NumberField<Dock> LENGTH = SCHEMA.number("length", "m", 0.0, 0.0);
  private static final NumberField<Dock> WIDTH = SCHEMA.number("width", "m", 0.0, 0.0);
  private static final NumberField<Dock> HEIGHT = SCHEMA.number("height", "m", 0.0, 0.0);
  private static final NumberField<Dock> THICKNESS = SCHEMA.number("thickness", "m", 0.0, 0.0);
  private static final NumberField<Dock> PSI = SCHEMA.number("psi", "rad", 0.0);
  private static final ValueField<Dock, Colour> COLOUR =
      SCHEMA.optionalChoice("colour", Colour.class);

  public static final MessageType<Dock> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends Dock> type() {
    return TYPE;
  }

  /** Outer length along psi, from the back wall to the ends of the fingers [m]. */
  public double length() {
    return require(LENGTH);
  }

  public Dock length(double value) {
    return put(LENGTH, value);
  }

  /** Outer width across psi [m]. */
  public double width() {
    return require(WIDTH);
  }

  public Dock width(double value) {
    return put(WIDTH, value);
  }

  /** Height, centred on z [m]. */
  public double height() {
    return require(HEIGHT);
  }

  public Dock height(double value) {
    return put(HEIGHT, value);
  }

  /** Thickness of the back wall and the fingers [m]. */
  public double thickness() {
    return require(THICKNESS);
  }

  public Dock thickness(double value) {
    return put(THICKNESS, value);
  }

  /** Direction from the back wall out of the entrance [rad], measured as the frame measures psi. */
  public double psi() {
    return require(PSI);
  }

  public Dock psi(double value) {
    return put(PSI, value);
  }

  /** The colour; empty if unknown. */
  @Override
  public Optional<Colour> colour() {
    return Optional.ofNullable(get(COLOUR));
  }

  public Dock colour(Colour colour) {
    return put(COLOUR, colour);
  }

  /**
   * The back wall, the finger left of psi seen from above in a z-up frame, and the other one. They
   * have the UID of the dock.
   */
  public List<Box> walls() {
    double half = thickness() / 2.0;
    double side = width() / 2.0 - half;
    Box back = wall(half - length() / 2.0, 0.0, thickness(), width());
    Box left = wall(0.0, side, length(), thickness());
    return List.of(back, left, wall(0.0, -side, length(), thickness()));
  }

  /** Centre line of the walls, from the end of one finger to that of the other. */
  public List<Point> outline() {
    double half = thickness() / 2.0;
    double end = length() / 2.0;
    double side = width() / 2.0 - half;
    double back = half - end;
    return List.of(at(end, side), at(back, side), at(back, -side), at(end, -side));
  }

  private Box wall(double ahead, double aside, double length, double width) {
    Point at = at(ahead, aside);
    Box box = new Box().length(length).width(width).height(height()).psi(psi());
    box.uid(uid()).referenceFrame(referenceFrame());
    box.x(at.x()).y(at.y()).z(at.z());
    return box;
  }

  /** Point of the frame at the given metres along and across psi. */
  private Point at(double ahead, double aside) {
    double along = referenceFrame().isEarth() ? Math.PI / 2.0 - psi() : psi();
    double cos = Math.cos(along);
    double sin = Math.sin(along);
    return metric().point(Point.of(ahead * cos - aside * sin, ahead * sin + aside * cos, 0.0));
  }

  @Override
  protected void move(PointConversion conversion) {
    psi(conversion.heading(center(), psi()));
    super.move(conversion);
  }

  @Override
  public double distanceTo(Point from) {
    return walls().stream().mapToDouble(wall -> wall.distanceTo(from)).min().orElseThrow();
  }
}
