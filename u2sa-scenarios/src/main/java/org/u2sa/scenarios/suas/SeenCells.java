package org.u2sa.scenarios.suas;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.Rotation;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Terrain;

/**
 * The judge's record of what was actually seen: 5 m cells whose corners were all in one image at
 * the required resolution, given the true pose of the camera, which looks straight down from the
 * aircraft's reference point.
 */
final class SeenCells {
  private static final double CELL_M = 5.0;

  /** A cell's corner and its name. */
  private record Cell(double eastM, double northM) {}

  private final SurveyPictures.Optics optics;
  private final double resolutionM;
  private final Terrain ground;
  private double lowestM = Double.POSITIVE_INFINITY;
  private double highestM = Double.NEGATIVE_INFINITY;
  private final List<Cell> missing = new ArrayList<>();
  private final int all;

  SeenCells(SuasField field, SurveyPictures.Optics optics) {
    this.optics = optics;
    resolutionM = field.resolutionM();
    ground = field.ground();
    List<Point> area = field.searchArea();
    if (area.isEmpty()) {
      all = 0;
      return;
    }
    double west = area.stream().mapToDouble(Point::x).min().orElseThrow();
    double east = area.stream().mapToDouble(Point::x).max().orElseThrow();
    double south = area.stream().mapToDouble(Point::y).min().orElseThrow();
    double north = area.stream().mapToDouble(Point::y).max().orElseThrow();
    for (double y = south; y < north; y += CELL_M) {
      for (double x = west; x < east; x += CELL_M) {
        if (SuasField.isInside(area, x + 0.5 * CELL_M, y + 0.5 * CELL_M)) {
          missing.add(new Cell(x, y));
        }
      }
    }
    all = missing.size();
  }

  /** Records an image. */
  void see(VehicleTruth truth) {
    Rotation frdFromNed = truth.attitude().nedFromFrd().transposed();
    Point at = truth.position();
    double reach = 3.0 * at.z();
    boolean isNew =
        missing.removeIf(
            cell ->
                Math.abs(cell.eastM() - at.x()) < reach
                    && Math.abs(cell.northM() - at.y()) < reach
                    && isSeen(frdFromNed, at, cell.eastM(), cell.northM())
                    && isSeen(frdFromNed, at, cell.eastM() + CELL_M, cell.northM())
                    && isSeen(frdFromNed, at, cell.eastM(), cell.northM() + CELL_M)
                    && isSeen(frdFromNed, at, cell.eastM() + CELL_M, cell.northM() + CELL_M));
    if (isNew) {
      double heightM = at.z() - ground.heightM(at.x(), at.y());
      lowestM = Math.min(lowestM, heightM);
      highestM = Math.max(highestM, heightM);
    }
  }

  private boolean isSeen(Rotation frdFromNed, Point at, double east, double north) {
    double depth = at.z() - ground.heightM(east, north);
    Point frd = frdFromNed.times(Point.of(north - at.y(), east - at.x(), depth));
    double focal = optics.focalPx();
    if (frd.z() <= 0.0
        || Math.abs(frd.y() / frd.z()) > 0.5 * (optics.width() - 1) / focal
        || Math.abs(frd.x() / frd.z()) > 0.5 * (optics.height() - 1) / focal) {
      return false;
    }
    // A pixel is 1 / focal wide at depth 1: rays of neighbouring pixels, by finite differences.
    double away = frd.distance();
    double offAxis = frd.z() / away; // cosine
    double riseEast = ground.riseEast(east, north);
    double riseNorth = ground.riseNorth(east, north);
    double normal = depth + riseEast * (east - at.x()) + riseNorth * (north - at.y());
    // cosine of the angle between the ray and the normal of the ground
    double incidence = normal / Math.sqrt(1.0 + riseEast * riseEast + riseNorth * riseNorth) / away;
    if (incidence <= 0.0) {
      return false;
    }
    double stretched = away * offAxis * offAxis / focal / incidence;
    double flat = away * offAxis / focal;
    return Math.max(stretched, flat) <= resolutionM;
  }

  /** Minimum height above the ground of an image that showed a cell for the first time [m]. */
  double lowestM() {
    return lowestM;
  }

  /** Maximum of these heights [m]. */
  double highestM() {
    return highestM;
  }

  /** Share of the cells that were seen, 0…1. */
  double share() {
    return all == 0 ? 1.0 : 1.0 - (double) missing.size() / all;
  }
}
