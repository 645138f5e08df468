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
  /**
   * Converts a sighting as received.
   *
   * @param defaultSigma standard deviation to use if the sighting states none [m]
   * @return empty if it cannot be converted to the map's frame
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

  /** Velocity along the map's axes [m/s]; empty if unknown. */
  Optional<Point> velocity() {
    return object.motion().velocity();
  }

  OptionalDouble velocitySigma() {
    return object.motion().velocitySigma();
  }
}
