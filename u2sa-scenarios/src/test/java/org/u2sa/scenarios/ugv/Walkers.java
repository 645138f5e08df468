package org.u2sa.scenarios.ugv;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Supplier;
import org.u2sa.device.port.LaserScanner;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.vehicle.VehicleTruth;

/**
 * Who walks straight on among the ground vehicle's obstacles, whatever is in the way: seen by its
 * laser only, and not solid. A touch is the vehicle's if it moves towards the walker, else the
 * walker's. Called on the thread that advances the clock.
 */
final class Walkers {
  static final double RADIUS_M = 0.3;
  private static final double LASER_FORWARD_M = 0.2; // as in LidarSensor.xml
  private static final double FRONT_M = 0.46; // of the Mini-Molle, from between its wheels
  private static final double REAR_M = 0.1;
  private static final double HALF_WIDTH_M = 0.26;
  private static final double STANDS_MPS = 0.05;

  /**
   * One walker.
   *
   * @param from where at first: east, north [m]
   * @param to direction of his way: a place that he passes [m]
   * @param sinceS when he sets out [s]
   */
  record Walker(Point from, Point to, double mps, double sinceS) {
    Point at(double timeS) {
      double gone = mps * Math.max(0.0, timeS - sinceS);
      Point way = to.minus(from);
      double share = gone / Math.hypot(way.x(), way.y());
      return Point.of(from.x() + share * way.x(), from.y() + share * way.y(), 0.0);
    }
  }

  private final List<Walker> all = new ArrayList<>();
  private final List<Walker> touched = new ArrayList<>();
  private final List<String> drivenInto = new ArrayList<>();
  private final List<String> touchedBy = new ArrayList<>();

  void add(Walker walker) {
    all.add(walker);
  }

  /** Whom the vehicle drove into. */
  List<String> drivenInto() {
    return drivenInto;
  }

  /** Who walked into the vehicle while it stood or backed off. */
  List<String> touchedBy() {
    return touchedBy;
  }

  /** Looks for touches. */
  void look(VehicleTruth truth) {
    double sin = Math.sin(truth.headingRad());
    double cos = Math.cos(truth.headingRad());
    for (Walker walker : all) {
      Point way = walker.at(truth.timeS()).minus(truth.position());
      double ahead = way.x() * sin + way.y() * cos;
      double right = way.x() * cos - way.y() * sin;
      double beyond =
          Math.hypot(
              Math.max(0.0, Math.max(ahead - FRONT_M, -REAR_M - ahead)),
              Math.max(0.0, Math.abs(right) - HALF_WIDTH_M));
      if (beyond < RADIUS_M && !touched.contains(walker)) {
        touched.add(walker);
        double towards =
            (truth.velocity().x() * way.x() + truth.velocity().y() * way.y())
                / Math.hypot(way.x(), way.y());
        (towards > STANDS_MPS ? drivenInto : touchedBy).add(walker + " at " + truth.timeS());
      }
    }
  }

  /** A laser that sees them too. */
  LaserScanner seenBy(LaserScanner laser, Supplier<VehicleTruth> truth) {
    return new LaserScanner() {
      private Optional<Scan> seen = Optional.empty();

      @Override
      public Optional<Scan> read(long nowMicros) {
        Optional<Scan> scan = laser.read(nowMicros);
        if (all.isEmpty() || isSeen(scan)) {
          return all.isEmpty() ? scan : seen;
        }
        seen = scan.map(newest -> among(newest, truth.get()));
        return seen;
      }

      private boolean isSeen(Optional<Scan> scan) {
        return scan.map(Scan::measuredAtMicros).equals(seen.map(Scan::measuredAtMicros));
      }
    };
  }

  private LaserScanner.Scan among(LaserScanner.Scan scan, VehicleTruth truth) {
    List<OptionalDouble> ranges = new ArrayList<>();
    for (RangeScan.Beam beam : scan.beams().beams()) {
      double farthest = beam.range().orElse(scan.beams().maxRange());
      double seen = farthest;
      for (Walker walker : all) {
        seen = Math.min(seen, rangeM(walker.at(truth.timeS()), truth, beam.angle()));
      }
      ranges.add(seen < farthest ? OptionalDouble.of(seen) : beam.range());
    }
    RangeScan among = (RangeScan) scan.beams().copy();
    among.beams(scan.beams().startAngle(), scan.beams().angleIncrement(), ranges);
    return new LaserScanner.Scan(scan.measuredAtMicros(), among);
  }

  /** To a walker along a beam [m]. */
  private static double rangeM(Point walker, VehicleTruth truth, double leftRad) {
    double azimuth = truth.headingRad() - leftRad;
    double sin = Math.sin(truth.headingRad());
    double cos = Math.cos(truth.headingRad());
    double de = walker.x() - truth.position().x() - LASER_FORWARD_M * sin;
    double dn = walker.y() - truth.position().y() - LASER_FORWARD_M * cos;
    double along = de * Math.sin(azimuth) + dn * Math.cos(azimuth);
    double beside = de * Math.cos(azimuth) - dn * Math.sin(azimuth);
    double half = RADIUS_M * RADIUS_M - beside * beside;
    return along > 0.0 && half > 0.0 ? along - Math.sqrt(half) : Double.POSITIVE_INFINITY;
  }
}
