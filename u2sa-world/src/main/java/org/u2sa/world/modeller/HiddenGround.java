package org.u2sa.world.modeller;

import java.util.Arrays;
import java.util.List;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.frame.Point;

/**
 * Ground hidden from a camera by objects that a scanner sees. Bright upright objects look like
 * paint on the ground behind them.
 */
public final class HiddenGround {
  private static final int SECTORS = 720;
  private static final double FOOT_M = 0.2; // footprint of an object beyond its echo
  private static final double ASIDE_M = 0.15; // offset of the camera from the vehicle's centre
  private static final double GROUND_M = 0.15; // above the vehicle's reference point
  private static final double TILTED_M = 0.1; // minimum drop of a ground echo below the scanner
  private static final long STALE = Clock.MICROS_PER_SECOND / 2;

  private final double[] nearest = new double[SECTORS];
  private double[] x = new double[1_024]; // newest scan's echoes, map coordinates [m]
  private double[] y = new double[1_024];
  private int echoes;
  private long scanned = Long.MIN_VALUE / 2;
  private double fromX;
  private double fromY;

  /**
   * Sets the newest scan. Ground echoes of a tilted scanner occlude nothing.
   *
   * @param up +1 if the map's z axis points up, else -1
   */
  public void scan(RangeScan scan, SensorPose pose, double up, long micros) {
    List<Double> ranges = scan.ranges();
    List<Boolean> returns = scan.returns();
    List<Double> angles = scan.angles();
    int beams = scan.beamCount();
    if (beams > x.length) {
      x = Arrays.copyOf(x, 2 * beams);
      y = Arrays.copyOf(y, 2 * beams);
    }
    echoes = 0;
    scanned = micros;
    for (int i = 0; i < beams; i++) {
      double range = ranges.get(i);
      if (returns.get(i) && range >= scan.minRange() && range <= scan.maxRange()) {
        double angle =
            angles.isEmpty() ? scan.startAngle() + i * scan.angleIncrement() : angles.get(i);
        Point echo = pose.at(angle, range);
        if (isGround(echo, pose, up)) {
          continue;
        }
        x[echoes] = echo.x();
        y[echoes++] = echo.y();
      }
    }
  }

  private static boolean isGround(Point echo, SensorPose pose, double up) {
    return up * (echo.z() - pose.vehicle().z()) < GROUND_M
        && up * (pose.place().z() - echo.z()) > TILTED_M;
  }

  /** Sets the viewpoint and time for the next queries. */
  public void lookFrom(double vehicleX, double vehicleY, long micros) {
    fromX = vehicleX;
    fromY = vehicleY;
    Arrays.fill(nearest, Double.POSITIVE_INFINITY);
    for (int i = 0; i < echoes && Math.abs(micros - scanned) <= STALE; i++) {
      double away = Math.hypot(x[i] - fromX, y[i] - fromY);
      int wide = 1 + (int) Math.min(SECTORS / 8.0, ASIDE_M / Math.max(0.1, away) * SECTORS / 6.28);
      int middle = sector(x[i], y[i]);
      for (int k = middle - wide; k <= middle + wide; k++) {
        int sector = Math.floorMod(k, SECTORS);
        nearest[sector] = Math.min(nearest[sector], away);
      }
    }
  }

  private int sector(double toX, double toY) {
    double turn = Math.atan2(toY - fromY, toX - fromX) / (2.0 * Math.PI);
    return Math.floorMod((int) Math.floor(turn * SECTORS), SECTORS);
  }

  /** Whether an object occludes a point from up to this many metres in front of it. */
  public boolean hides(double placeX, double placeY, double reachM) {
    double behind = Math.hypot(placeX - fromX, placeY - fromY) - nearest[sector(placeX, placeY)];
    return behind > FOOT_M && behind <= reachM;
  }
}
