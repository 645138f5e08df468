package org.u2sa.estimation;

import java.util.Arrays;
import java.util.Optional;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.frame.Point;

/**
 * Wind computed from airspeed and ground speed on different headings: the same on all headings if
 * the airspeed is right, different on each if it is wrong.
 */
final class WindInTurns {
  private static final int SECTORS = 8; // heading sectors
  private static final int ENOUGH = 4; // number of sectors with a wind
  private static final double SAME_MPS = 3.0; // maximum deviation from their mean
  private static final double SMOOTHING_S = 4.0;
  private static final double VISIT_S = 10.0; // longer after the last visit, a sector starts over
  private static final double VALID_S = 120.0;

  private final double[] north = new double[SECTORS]; // wind vector, downwind [m/s]
  private final double[] east = new double[SECTORS];
  private final long[] seenMicros = new long[SECTORS]; // MIN_VALUE: never

  WindInTurns() {
    clear();
  }

  void clear() {
    Arrays.fill(seenMicros, Long.MIN_VALUE);
  }

  /** Adds the wind on a heading [rad]. */
  void see(double psi, double northMps, double eastMps, long micros) {
    int sector = Math.floorMod((int) Math.floor(psi / (2.0 * Math.PI) * SECTORS), SECTORS);
    double sinceS =
        seenMicros[sector] == Long.MIN_VALUE
            ? Double.POSITIVE_INFINITY
            : Clock.seconds(micros - seenMicros[sector]);
    double share = sinceS > VISIT_S ? 1.0 : Math.min(1.0, sinceS / SMOOTHING_S);
    north[sector] += share * (northMps - north[sector]);
    east[sector] += share * (eastMps - east[sector]);
    seenMicros[sector] = micros;
  }

  /** Mean wind if enough headings agree: x north, y east [m/s]. */
  Optional<Point> agreed(long nowMicros) {
    Point sum = Point.ORIGIN;
    int count = 0;
    for (int i = 0; i < SECTORS; i++) {
      if (isValid(i, nowMicros)) {
        sum = sum.plus(Point.of(north[i], east[i], 0.0));
        count++;
      }
    }
    if (count < ENOUGH) {
      return Optional.empty();
    }
    Point mean = sum.times(1.0 / count);
    for (int i = 0; i < SECTORS; i++) {
      if (isValid(i, nowMicros) && Math.hypot(north[i] - mean.x(), east[i] - mean.y()) > SAME_MPS) {
        return Optional.empty();
      }
    }
    return Optional.of(mean);
  }

  private boolean isValid(int sector, long nowMicros) {
    return seenMicros[sector] != Long.MIN_VALUE
        && Clock.seconds(nowMicros - seenMicros[sector]) < VALID_S;
  }
}
