package org.u2sa.scenarios.ugv;

import java.util.Locale;
import java.util.OptionalDouble;
import org.u2sa.sim.world.Surface;
import org.u2sa.sim.world.Terrain;

/**
 * The conditions of a drive: motors, load and ground.
 *
 * @param mismatch fraction by which the right motor is stronger and the left one weaker, −0.5…0.5;
 *     empty: up to ±0.05, by the seed
 * @param payloadKg mass above the vehicle's centre of gravity [kg]
 * @param words deviations from the default, for reports; empty if none
 */
record DriveConditions(
    OptionalDouble mismatch, double payloadKg, Surface surface, Terrain terrain, String words) {

  /** Default conditions: an unloaded vehicle on a level lawn. */
  static DriveConditions usual() {
    return new DriveConditions(OptionalDouble.empty(), 0.0, Surface.lawn(), Terrain.flat(), "");
  }

  /** Formats a number for {@link #words} without trailing zeros. */
  static String figure(double value) {
    return value == Math.rint(value)
        ? String.format(Locale.ROOT, "%.0f", value)
        : String.valueOf(value);
  }
}
