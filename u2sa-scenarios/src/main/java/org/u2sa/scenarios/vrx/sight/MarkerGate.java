package org.u2sa.scenarios.vrx.sight;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.messages.frame.Point;

/**
 * A gate between two markers that have been seen, on a plane with axes north and east [m].
 *
 * @param port marker to leave to port
 * @param starboard marker to leave to starboard
 * @param place the gate's position in the course, by the type of its port marker
 */
public record MarkerGate(Point port, Point starboard, Place place) {
  /** First, in between, or last. */
  public enum Place {
    FIRST,
    BETWEEN,
    LAST
  }

  /**
   * A marker to port.
   *
   * @param gate place of its gate in the course
   */
  public record Port(Point at, Place gate) {}

  private static final double NARROWEST_M = 10.0;
  private static final double WIDEST_M = 27.0;

  /** Gates between markers of opposite sides that are mutually nearest. */
  public static List<MarkerGate> among(List<Port> ports, List<Point> starboards) {
    List<MarkerGate> gates = new ArrayList<>();
    for (Port port : ports) {
      Optional<Point> partner =
          starboards.stream()
              .min((a, b) -> Double.compare(a.flatDistanceTo(port.at), b.flatDistanceTo(port.at)));
      if (partner.isEmpty()) {
        continue;
      }
      double width = partner.get().flatDistanceTo(port.at);
      boolean isMutual =
          ports.stream().allMatch(other -> other.at.flatDistanceTo(partner.get()) >= width);
      if (isMutual && width >= NARROWEST_M && width <= WIDEST_M) {
        gates.add(new MarkerGate(port.at, partner.get(), port.gate));
      }
    }
    return gates;
  }

  public double widthM() {
    return port.flatDistanceTo(starboard);
  }

  public Point middle() {
    return port.plus(starboard).times(0.5);
  }

  /** Unit vector of the way through. */
  public Point way() {
    double width = widthM();
    return Point.of((starboard.y() - port.y()) / width, (port.x() - starboard.x()) / width, 0.0);
  }

  /** Distance to go to the gate along its axis [m]; negative beyond it. */
  public double aheadM(Point from) {
    Point to = middle().minus(from);
    return to.x() * way().x() + to.y() * way().y();
  }

  /** Distance from its axis, positive to starboard [m]. */
  public double asideM(Point at) {
    Point from = at.minus(middle());
    return from.y() * way().x() - from.x() * way().y();
  }

  /** Point on its axis at this distance beyond the gate [m]. */
  public Point beyond(double metres) {
    Point place = middle().plus(way().times(metres));
    return Point.of(place.x(), place.y(), 0.0);
  }

  /** Whether a movement passes through it in its direction. */
  public boolean isPassed(Point before, Point now) {
    return aheadM(before) > 0.0 && aheadM(now) <= 0.0 && Math.abs(asideM(now)) < widthM() / 2.0;
  }
}
