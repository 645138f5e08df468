package org.u2sa.world.object;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.world.modeller.Sighting;

/**
 * A sighting in the map.
 *
 * @param object in the map's frame
 * @param place of its centre [m from the map's anchor]
 * @param sigma standard deviations of the place, the vehicle's own included [m]
 */
record Detection(ObjectDescription object, Point place, Point sigma) {
  /**
   * A sighting as it came.
   *
   * @param defaultSigma standard deviation if it states none [m]
   * @return empty if there is no way into the map
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
                    object.motion().sigma().orElseThrow()));
  }

  /** Velocity along the map's axes [m/s]; empty if it is not known. */
  Optional<Point> velocity() {
    return object.motion().velocity();
  }

  OptionalDouble velocitySigma() {
    return object.motion().velocitySigma();
  }
}
