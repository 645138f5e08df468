package org.u2sa.planning.air;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.seen.PlanarShape;

/** Keep-out regions of an aircraft: around shapes, and outside corridors. Immutable. */
final class KeepOut {
  private static final double TOUCH = 0.999; // paths exactly along the edge are free

  record Round(double northM, double eastM, double avoidM) {}

  /** A line with a clearance. */
  private record Wall(double n1, double e1, double n2, double e2, double avoidM) {}

  private final List<Round> rounds = new ArrayList<>();
  private final List<Wall> walls = new ArrayList<>();
  private final List<PlanarShape> corridors;
  private final double sampleM;

  /**
   * @param clearanceM clearance to keep from shapes [m]
   * @param start start pose; the clearance is reduced for shapes that are closer to it
   */
  KeepOut(List<PlanarShape> shapes, List<PlanarShape> corridors, double clearanceM, Pose start) {
    this.corridors = corridors;
    sampleM = Math.max(1.0, clearanceM);
    for (PlanarShape shape : shapes) {
      double away = shape.distanceM(start.northM(), start.eastM());
      double kept = shape.radiusM() + Math.min(clearanceM, 0.98 * away);
      for (int i = 0; i < shape.count(); i++) {
        rounds.add(new Round(shape.northM(i), shape.eastM(i), kept));
        int next = i + 1 < shape.count() ? i + 1 : 0;
        boolean joined =
            shape.kind() == PlanarShape.Kind.AREA
                || (shape.kind() == PlanarShape.Kind.CHAIN && next > 0);
        if (joined) {
          walls.add(
              new Wall(
                  shape.northM(i), shape.eastM(i), shape.northM(next), shape.eastM(next), kept));
        }
      }
    }
    for (PlanarShape corridor : corridors) { // paths may have to round their corners
      for (int i = 0; i < corridor.count(); i++) {
        rounds.add(new Round(corridor.northM(i), corridor.eastM(i), 0.0));
      }
    }
  }

  /** Maximum spacing of points for checking whether a curve keeps clear [m]. */
  double arcSampleM() {
    return 0.5 * sampleM;
  }

  List<Round> rounds() {
    return rounds;
  }

  /** Whether a straight path keeps its clearance from everything. */
  boolean isFree(double n1, double e1, double n2, double e2) {
    for (Round round : rounds) {
      if (PlanarShape.segmentM(round.northM(), round.eastM(), n1, e1, n2, e2)
          < TOUCH * round.avoidM()) {
        return false;
      }
    }
    for (Wall wall : walls) {
      if (PlanarShape.cross(n1, e1, n2, e2, wall.n1(), wall.e1(), wall.n2(), wall.e2())
          || PlanarShape.segmentM(n1, e1, wall.n1(), wall.e1(), wall.n2(), wall.e2())
              < TOUCH * wall.avoidM()
          || PlanarShape.segmentM(n2, e2, wall.n1(), wall.e1(), wall.n2(), wall.e2())
              < TOUCH * wall.avoidM()) {
        return false; // nearest at an end of either, or they cross; ends are round
      }
    }
    return isInside(n1, e1, n2, e2);
  }

  private boolean isInside(double n1, double e1, double n2, double e2) {
    if (corridors.isEmpty()) {
      return true;
    }
    int steps = Math.max(1, (int) Math.ceil(Math.hypot(n2 - n1, e2 - e1) / sampleM));
    for (int k = 0; k <= steps; k++) {
      double north = n1 + (n2 - n1) * k / steps;
      double east = e1 + (e2 - e1) * k / steps;
      boolean inside = false;
      for (PlanarShape corridor : corridors) {
        inside |= corridor.distanceM(north, east) == 0.0;
      }
      if (!inside) {
        return false;
      }
    }
    return true;
  }
}
