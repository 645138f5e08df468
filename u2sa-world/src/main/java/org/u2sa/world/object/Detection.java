package org.u2sa.world.object;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.world.modeller.Sighting;

/**
 * A detection in map coordinates.
 *
 * @param object object in the map's frame
 * @param place position of its centre [m from the map's anchor]
 * @param sigma standard deviations of the position, including the vehicle's own uncertainty [m]
 */
record Detection(ObjectDescription object, Point place, Point sigma) {
  /** Bounds of a standard deviation [m, m/s]: claims beyond have variances that lose precision. */
  private static final double MIN_SIGMA = 1e-6;

  private static final double MAX_SIGMA = 1e6;
  private static final double FARTHEST_M = 1e7;
  private static final double FASTEST_MPS = 1e4;

  /**
   * Converts a sighting as received. Its standard deviations are bounded, and so is its velocity:
   * an absurd one counts as unknown.
   *
   * @param defaultSigma standard deviation to use if the sighting states none [m]
   * @return empty if it cannot be converted to the map's frame, or is absurdly far away or large
   */
  static Optional<Detection> of(ObjectDescription seen, Sighting sighting, double defaultSigma) {
    ObjectDescription stated = seen;
    if (seen.motion().sigma().isEmpty()) {
      stated = seen.copy();
      stated.motion().sigma(Point.of(defaultSigma, defaultSigma, defaultSigma));
    }
    return sighting
        .frame()
        .placed(stated, sighting.vehicle())
        .map(
            object ->
                new Detection(
                    object,
                    sighting.frame().metres(object.center()),
                    bounded(object.motion().sigma().orElseThrow())))
        .filter(detection -> detection.place().distance() < FARTHEST_M)
        .filter(detection -> Extent.isWithin(detection.object(), FARTHEST_M));
  }

  private static Point bounded(Point sigma) {
    return Point.of(bounded(sigma.x()), bounded(sigma.y()), bounded(sigma.z()));
  }

  private static double bounded(double sigma) {
    return Math.max(MIN_SIGMA, Math.min(MAX_SIGMA, sigma));
  }

  /** Velocity along the map's axes [m/s]; empty if unknown. */
  Optional<Point> velocity() {
    return object.motion().velocity().filter(each -> each.distance() < FASTEST_MPS);
  }

  OptionalDouble velocitySigma() {
    OptionalDouble sigma = object.motion().velocitySigma();
    return sigma.isPresent() ? OptionalDouble.of(bounded(sigma.getAsDouble())) : sigma;
  }
}
