package org.u2sa.sim.file;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.xml.XmlElement;
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
 * @param source element of the file, for messages
 */
record Body(
    double massKg,
    Point inertia,
    boolean isAboutReference,
    Point gravityCentre,
    Footprint footprint,
    XmlElement source) {
  private static final double HIGHEST_GRAVITY_CENTRE_M = 2.0; // of a ground vehicle
  private static final double LONGEST_M = 1_000.0;
  private static final double HEAVIEST = 1e9;
  private static final double ROUNDED = 0.01; // moments in files are rounded

  static Body read(FileElement body) {
    double mass = body.positive("mass", "kg", HEAVIEST);
    Point inertia = body.vector("inertia", "kg m^2", 1e-9, HEAVIEST);
    double largest = Math.max(inertia.x(), Math.max(inertia.y(), inertia.z()));
    if (2.0 * largest > (inertia.x() + inertia.y() + inertia.z()) * (1.0 + ROUNDED)) {
      throw body.xml()
          .child("inertia")
          .orElse(body.xml())
          .error(
              inertia
                  + " kg m^2: no body has these moments; expected none above the sum of the other"
                  + " two");
    }
    Point gravityCentre = body.vector("gravityCentre", "m", -LONGEST_M, LONGEST_M, Point.ORIGIN);
    boolean isAboutReference =
        body.has("inertiaAbout")
            && body.choice("inertiaAbout", About.class) == About.REFERENCE_POINT;
    Footprint footprint = footprint(body.part("outline"));
    body.end();
    return new Body(mass, inertia, isAboutReference, gravityCentre, footprint, body.xml());
  }

  /** A body whose mass and inertia come from another file. */
  static Body outline(FileElement body) {
    Footprint footprint = footprint(body.part("outline"));
    body.end();
    return new Body(0.0, Point.ORIGIN, false, Point.ORIGIN, footprint, body.xml());
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

  /**
   * Height of a ground vehicle's centre of gravity above its reference point [m].
   *
   * @throws BadInputException at the body's element if it is not above the ground, or too high
   */
  double gravityHeightM() {
    double down = gravityCentre.z();
    if (!(down >= -HIGHEST_GRAVITY_CENTRE_M && down <= 0.0)) {
      throw source
          .child("gravityCentre")
          .orElse(source)
          .error(
              String.format(
                  "the third number is %s m: expected %s…0 m; down is positive, from the ground"
                      + " under the vehicle",
                  down, -HIGHEST_GRAVITY_CENTRE_M));
    }
    return down == 0.0 ? 0.0 : -down;
  }

  /** Moments of inertia about the reference point [kg m²]. */
  Point inertiaAboutReference() {
    return isAboutReference ? inertia : shifted(1.0);
  }

  /**
   * Moments of inertia about the centre of gravity [kg m²].
   *
   * @throws BadInputException at the body's element if one is not above 0
   */
  Point inertiaAboutGravityCentre() {
    Point own = isAboutReference ? shifted(-1.0) : inertia;
    if (!(own.x() > 0.0 && own.y() > 0.0 && own.z() > 0.0)) {
      throw source
          .child("inertia")
          .orElse(source)
          .error(
              "about the centre of gravity it would be " + own + " kg m^2; expected more than 0");
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
