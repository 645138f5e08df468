package org.u2sa.sim.sensor;

/**
 * What a compass feels beside the earth.
 *
 * @param eastUt field of something at this place, towards east [µT]
 * @param northUt towards north [µT]
 * @param leftA current of the left, or only, motor, driving forward positive [A]
 * @param rightA current of the right motor [A]
 */
public record CompassField(double eastUt, double northUt, double leftA, double rightA) {
  /** Nothing. */
  public static CompassField none() {
    return new CompassField(0.0, 0.0, 0.0, 0.0);
  }
}
