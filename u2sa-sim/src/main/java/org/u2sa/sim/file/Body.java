package org.u2sa.sim.file;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.file.element.FileElement;
import org.u2sa.sim.world.Footprint;

/**
 * A vehicle's body. Axes: forward, right, down.
 *
 * @param massKg mass [kg]
 * @param inertia moments of inertia about the centre of gravity or the reference point [kg m²]
 * @param isAboutReference whether about the reference point
 * @param gravityCentre from the reference point [m]
 * @param footprint collision outline
 */
record Body(
    double massKg,
    Point inertia,
    boolean isAboutReference,
    Point gravityCentre,
    Footprint footprint) {
  private static final double LONGEST_M = 1_000.0;
  private static final double HEAVIEST = 1e9;

  static Body read(FileElement body) {
    double mass = body.positive("mass", "kg", HEAVIEST);
    Point inertia = body.vector("inertia", "kg m^2", 1e-9, HEAVIEST);
    Point gravityCentre = body.vector("gravityCentre", "m", -LONGEST_M, LONGEST_M, Point.ORIGIN);
    boolean isAboutReference =
        body.has("inertiaAbout")
            && body.choice("inertiaAbout", About.class) == About.REFERENCE_POINT;
    Footprint footprint = footprint(body.part("outline"));
    body.end();
    return new Body(mass, inertia, isAboutReference, gravityCentre, footprint);
  }

  /** A body whose mass and inertia come from another file. */
  static Body outline(FileElement body) {
    Footprint footprint = footprint(body.part("outline"));
    body.end();
    return new Body(0.0, Point.ORIGIN, false, Point.ORIGIN, footprint);
  }

  private enum About {
    GRAVITY_CENTRE,
    REFERENCE_POINT
  }

  private static Footprint footprint(FileElement outline) {
    double bottom = outline.number("bottom", "m", -LONGEST_M, LONGEST_M);
    double top = outline.number("top", "m", -LONGEST_M, LONGEST_M);
    List<Point> corners = new ArrayList<>();
    if (outline.has("corners")) {
      List<Double> numbers = outline.numbers("corners", "m", -LONGEST_M, LONGEST_M, 100);
      if (numbers.size() % 2 != 0) {
        throw outline
            .xml()
            .error("corners: expected pairs of numbers: ahead right; ahead right; …");
      }
      for (int i = 0; i < numbers.size(); i += 2) {
        corners.add(Point.of(numbers.get(i), numbers.get(i + 1), 0.0));
      }
      outline.end();
      return outline.made(() -> new Footprint(corners, bottom, top));
    }
    double ahead = outline.number("ahead", "m", -LONGEST_M, LONGEST_M);
    double behind = outline.number("behind", "m", -LONGEST_M, LONGEST_M);
    double width = outline.positive("width", "m", LONGEST_M);
    outline.end();
    return outline.made(() -> Footprint.rectangle(ahead, behind, width, bottom, top));
  }

  /** Moments of inertia about the reference point [kg m²]. */
  Point inertiaAboutReference() {
    return isAboutReference ? inertia : shifted(1.0);
  }

  /**
   * Moments of inertia about the centre of gravity [kg m²].
   *
   * @throws IllegalArgumentException if one is not above 0
   */
  Point inertiaAboutGravityCentre() {
    Point own = isAboutReference ? shifted(-1.0) : inertia;
    if (!(own.x() > 0.0 && own.y() > 0.0 && own.z() > 0.0)) {
      throw new IllegalArgumentException(
          "inertia about the centre of gravity would be " + own + "; expected more than 0");
    }
    return own;
  }

  /** Parallel-axis theorem. */
  private Point shifted(double sign) {
    Point g = gravityCentre;
    double m = sign * massKg;
    return Point.of(
        inertia.x() + m * (g.y() * g.y() + g.z() * g.z()),
        inertia.y() + m * (g.x() * g.x() + g.z() * g.z()),
        inertia.z() + m * (g.x() * g.x() + g.y() * g.y()));
  }
}
