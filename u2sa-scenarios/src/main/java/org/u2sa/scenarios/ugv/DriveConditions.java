package org.u2sa.scenarios.ugv;

import java.util.Locale;
import java.util.OptionalDouble;
import org.u2sa.sim.world.Surface;
import org.u2sa.sim.world.Terrain;

/**
 * The conditions of a drive: motors, load and ground.
 *
 * @param mismatch share by which the right motor is stronger and the left one weaker, −0.5…0.5;
 *     empty: up to 0.05 either way, by the seed
 * @param payloadKg above the vehicle's centre of gravity [kg]
 * @param words what is unusual, for reports; empty if nothing is
 */
record DriveConditions(
    OptionalDouble mismatch, double payloadKg, Surface surface, Terrain terrain, String words) {

  /** An empty vehicle on a level lawn. */
  static DriveConditions usual() {
    return new DriveConditions(OptionalDouble.empty(), 0.0, Surface.lawn(), Terrain.flat(), "");
  }

  /** A number for {@link #words}, without needless zeros. */
  static String figure(double value) {
    return value == Math.rint(value)
        ? String.format(Locale.ROOT, "%.0f", value)
        : String.valueOf(value);
  }
}
