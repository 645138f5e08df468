package org.u2sa.scenarios.roboboat;

import java.util.Random;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.marine.Hoop;
import org.u2sa.sim.vehicle.VehicleTruth;

/**
 * Flight of a foam dart without drag, from a gun that is fixed on the bow.
 *
 * @param from muzzle: east, north, up [m]
 * @param velocity east, north, up [m/s]
 */
public record Dart(Point from, Point velocity) {
  private static final Point MUZZLE = Point.of(0.5, 0.0, -0.5); // forward, right, down
  private static final double SPEED_MPS = 15.0;
  private static final double ELEVATION_RAD = Math.toRadians(13.0);
  private static final double SPREAD_RAD = Math.toRadians(1.0); // standard deviation, each axis
  private static final double G_MPS2 = 9.81;

  /** A shot from a boat in this state. */
  public static Dart shot(VehicleTruth boat, Random random) {
    double up = ELEVATION_RAD + SPREAD_RAD * random.nextGaussian();
    double right = SPREAD_RAD * random.nextGaussian();
    Point frd =
        Point.of(
            SPEED_MPS * Math.cos(up) * Math.cos(right),
            SPEED_MPS * Math.cos(up) * Math.sin(right),
            -SPEED_MPS * Math.sin(up));
    Point muzzle = boat.attitude().nedFromFrd().times(MUZZLE);
    Point way = boat.attitude().nedFromFrd().times(frd);
    return new Dart(
        boat.position().plus(muzzle.axesExchanged()), boat.velocity().plus(way.axesExchanged()));
  }

  /** Whether the dart flies through an upright hoop in LOCAL_ENU. */
  public boolean passes(Hoop hoop) {
    double east = Math.cos(hoop.psi());
    double north = Math.sin(hoop.psi());
    Point way = hoop.center().minus(from);
    double closing = velocity.x() * east + velocity.y() * north;
    double timeS = closing == 0.0 ? -1.0 : (way.x() * east + way.y() * north) / closing;
    if (timeS <= 0.0) {
      return false;
    }
    Point at = from.plus(velocity.times(timeS));
    double up = at.z() - G_MPS2 * timeS * timeS / 2.0 - hoop.center().z();
    double aside = Math.hypot(at.x() - hoop.center().x(), at.y() - hoop.center().y());
    return Math.hypot(aside, up) < hoop.radius() - hoop.thickness() / 2.0;
  }
}
