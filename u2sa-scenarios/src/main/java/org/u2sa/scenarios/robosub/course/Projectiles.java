package org.u2sa.scenarios.robosub.course;

import java.util.Optional;
import java.util.Random;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.vehicle.VehicleTruth;

/** True paths of markers and torpedoes. Places are north, east and down of the start [m]. */
final class Projectiles {
  private static final double BELOW_M = 0.15; // depth of the dropper below the vehicle's middle
  private static final double SINKING_MPS = 0.4;
  private static final double SLOWED_S = 0.3; // time constant of a marker's level speed
  private static final double DRIFT_MPS = 0.03; // standard deviation, north and east
  private static final double SPREAD_RAD = 0.02; // spread of a torpedo's direction, either way
  private static final double REACH_M = 5.0;

  private final Random random;

  Projectiles(long seed) {
    random = new Random(seed);
  }

  /** Position on the floor of a marker released now. */
  Point landing(VehicleTruth truth, double floorM) {
    Point from =
        truth.position().axesExchanged().plus(truth.velocity().axesExchanged().times(SLOWED_S));
    double sinkingS = Math.max(0.0, floorM - from.z() - BELOW_M) / SINKING_MPS;
    return Point.of(
        from.x() + DRIFT_MPS * random.nextGaussian() * sinkingS,
        from.y() + DRIFT_MPS * random.nextGaussian() * sinkingS,
        floorM);
  }

  /**
   * Distance from a hoop's middle at which a torpedo that is launched now crosses the hoop's plane
   * [m]; empty if it does not.
   *
   * @param normal of the hoop, level unit vector
   */
  Optional<Double> missM(VehicleTruth truth, Point hoop, Point normal) {
    Point aim =
        Point.of(1.0, SPREAD_RAD * random.nextGaussian(), SPREAD_RAD * random.nextGaussian());
    Point way = truth.attitude().nedFromFrd().times(aim);
    Point off = hoop.minus(truth.position().axesExchanged());
    double reach = off.dot(normal) / way.dot(normal);
    return reach > 0.0 && reach < REACH_M
        ? Optional.of(off.minus(way.times(reach)).distance())
        : Optional.empty();
  }
}
