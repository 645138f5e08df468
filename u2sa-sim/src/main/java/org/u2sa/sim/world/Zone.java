package org.u2sa.sim.world;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.IntStream;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.frame.UtmGrid;
import org.u2sa.messages.shape.Polygon;

/**
 * A named polygon on the ground, at any height.
 *
 * @param name name in reports
 * @param kind purpose of the zone
 * @param eastM corners in order [m]
 * @param northM corners in order [m]
 * @param surface driving surface in the zone; empty: the world's
 */
public record Zone(
    String name, Kind kind, double[] eastM, double[] northM, Optional<Surface> surface) {
  /** Purpose of a zone. */
  public enum Kind {
    /** Entries and exits are reported. */
    JUDGE,
    /** An entry breaks a rule. */
    KEEP_OUT,
    /** A patch of a different surface. */
    PATCH
  }

  /**
   * Reads an element {@code <zone>} of a world file.
   *
   * @param object the object in the element
   * @throws BadInputException naming file, line, element, value and what was expected
   */
  public static Zone read(XmlElement element, ObjectDescription object, LocalPlane plane) {
    if (!(object instanceof Polygon area) || area.points().size() < 3) {
      throw element.error(object.type().name() + ": expected a <polygon> of three points or more");
    }
    ReferenceFrame frame = object.referenceFrame();
    if (frame.isBody()) {
      throw element.error(frame + ": expected a frame of the world");
    }
    List<Point> corners =
        area.points().stream().map(point -> Zone.inWorld(frame, plane, point)).toList();
    Optional<Surface> surface = element.child("surface").map(Zone::surface);
    Kind kind =
        ElementValues.choice(
            element, "kind", Kind.class, surface.isPresent() ? Kind.PATCH : Kind.JUDGE);
    if (kind == Kind.PATCH && surface.isEmpty()) {
      throw ElementValues.lacks(element, "surface");
    }
    return new Zone(
        object.uid(),
        kind,
        corners.stream().mapToDouble(Point::x).toArray(),
        corners.stream().mapToDouble(Point::y).toArray(),
        surface);
  }

  private static Surface surface(XmlElement element) {
    try {
      return EnvironmentElement.surface(element);
    } catch (BadInputException e) {
      throw e;
    } catch (IllegalArgumentException e) {
      throw element.error(e.getMessage(), e);
    }
  }

  static Point inWorld(ReferenceFrame frame, LocalPlane plane, Point place) {
    if (frame.isEarth()) {
      return plane.point(Geodetic.of(UtmGrid.global(frame, place)));
    }
    return frame.equals(ReferenceFrame.LOCAL_NED)
        ? Point.of(place.y(), place.x(), -place.z())
        : place;
  }

  /** Its corners in order: east, north, 0 [m]. */
  public List<Point> corners() {
    return IntStream.range(0, eastM.length)
        .mapToObj(i -> Point.of(eastM[i], northM[i], 0.0))
        .toList();
  }

  /** Whether a point lies in it (even-odd rule). */
  public boolean contains(double east, double north) {
    boolean inside = false;
    for (int i = 0, j = eastM.length - 1; i < eastM.length; j = i++) {
      boolean crosses = northM[i] > north != northM[j] > north;
      if (crosses
          && east
              < (eastM[j] - eastM[i]) * (north - northM[i]) / (northM[j] - northM[i]) + eastM[i]) {
        inside = !inside;
      }
    }
    return inside;
  }

  /** A surface with the patches of zones; where they overlap, the last one applies. */
  static Surface patched(Surface around, List<Zone> zones) {
    List<Zone> patches = zones.stream().filter(zone -> zone.surface.isPresent()).toList();
    return patches.isEmpty() ? around : new Patched(around, patches);
  }

  private record Patched(Surface around, List<Zone> patches) implements Surface {
    private Surface at(double east, double north) {
      for (int i = patches.size() - 1; i >= 0; i--) {
        if (patches.get(i).contains(east, north)) {
          return patches.get(i).surface.orElse(around);
        }
      }
      return around;
    }

    @Override
    public double grip(double eastM, double northM) {
      return at(eastM, northM).grip(eastM, northM);
    }

    @Override
    public double rollingResistance(double eastM, double northM) {
      return at(eastM, northM).rollingResistance(eastM, northM);
    }
  }

  @Override
  public String toString() {
    return String.format(
        Locale.ROOT,
        "zone %s: %s of %d corners",
        name,
        kind.name().toLowerCase(Locale.ROOT).replace('_', '-'),
        eastM.length);
  }
}
