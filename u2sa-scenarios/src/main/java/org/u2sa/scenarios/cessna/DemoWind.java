package org.u2sa.scenarios.cessna;

import java.util.SplittableRandom;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.u2sa.sim.atmosphere.Wind;

/**
 * The wind of a demo flight.
 *
 * @param speedMps speed at every height, or with shear at 6 m above ground [m/s]
 * @param fromRad direction it blows from, clockwise from true north [rad]
 * @param shear whether speed increases with height
 */
record DemoWind(double speedMps, double fromRad, boolean shear) {
  private static final double STRONGEST_MPS = 8.0;
  private static final double STRONGEST_ASKED_FOR_MPS = 30.0;
  private static final double FULL_CIRCLE_DEG = 360.0;
  private static final Pattern TEXT = Pattern.compile("(\\d+(?:\\.\\d+)?)@(\\d+(?:\\.\\d+)?)");

  /** Random wind from a seed: any direction, up to 8 m/s. */
  static DemoWind ofSeed(long seed) {
    SplittableRandom random =
        new SplittableRandom(seed); // unlike Random, decorrelates adjacent seeds
    return new DemoWind(
        STRONGEST_MPS * random.nextDouble(), 2.0 * Math.PI * random.nextDouble(), false);
  }

  /**
   * Parses {@code calm} or {@code SPEED@DIRECTION}, in m/s and degrees true (where the wind blows
   * from).
   *
   * @throws IllegalArgumentException if it is neither
   */
  static DemoWind parse(String text) {
    if (text.equals("calm")) {
      return new DemoWind(0.0, 0.0, false);
    }
    Matcher matcher = TEXT.matcher(text);
    if (matcher.matches()) {
      double speed = Double.parseDouble(matcher.group(1));
      double from = Double.parseDouble(matcher.group(2));
      if (speed <= STRONGEST_ASKED_FOR_MPS && from <= FULL_CIRCLE_DEG) {
        return new DemoWind(speed, Math.toRadians(from), false);
      }
    }
    throw new IllegalArgumentException(
        "wind \""
            + text
            + "\": expected \"calm\", or speed and direction such as 5@270 (0…30 m/s, 0…360 degrees)");
  }

  /** Wind model for an aircraft simulated in this process, with gusts from the seed. */
  Wind wind(long seed) {
    return Wind.gusty(fromRad, speedMps, seed).withShear(shear);
  }

  /** Copy with or without shear; the wind near the ground is the same. */
  DemoWind withShear(boolean growsWithHeight) {
    return new DemoWind(speedMps, fromRad, growsWithHeight);
  }
}
