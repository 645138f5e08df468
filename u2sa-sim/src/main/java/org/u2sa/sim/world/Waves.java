package org.u2sa.sim.world;

import java.util.Random;
import org.u2sa.messages.frame.Gravity;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.motion.Arguments;

/**
 * Surface waves in deep water as a sum of linear (Airy) components: ζ = Σ a cos(k · x − ω t + φ), k
 * = ω²/g; orbital motion and pressure decay with depth by e^(−k d) (Fossen 2021, section 10.2).
 * Immutable.
 */
public final class Waves {
  private static final int COMPONENTS = 40;
  private static final double LOWEST = 0.5; // relative to the peak frequency
  private static final double HIGHEST = 3.5;
  private static final double JONSWAP_PEAK = 3.3; // γ, mean of the JONSWAP measurements
  private static final double STEEPEST = 1.0 / 7.0; // height over length of breaking waves

  private final double[] amplitude; // a [m]
  private final double[] frequency; // ω [rad/s]
  private final double[] east; // east component of k [rad/m]
  private final double[] north; // north component of k [rad/m]
  private final double[] phase; // φ [rad]

  private Waves(int count) {
    amplitude = new double[count];
    frequency = new double[count];
    east = new double[count];
    north = new double[count];
    phase = new double[count];
  }

  /** Shape of the spectrum. */
  public enum Spectrum {
    /** One component. */
    REGULAR,
    /** Fully developed sea. */
    PIERSON_MOSKOWITZ,
    /** Growing sea of limited fetch, γ = 3.3. */
    JONSWAP
  }

  /**
   * Creates waves.
   *
   * @param heightM significant height, four standard deviations; of regular waves, from trough to
   *     crest [m]
   * @param periodS period of the spectrum's peak [s]
   * @param towardsRad direction of travel, clockwise from north [rad]
   * @param spreadRad standard deviation of the components' directions [rad]
   * @throws IllegalArgumentException if a value is outside its range, or the waves would break
   */
  public static Waves of(
      Spectrum spectrum,
      double heightM,
      double periodS,
      double towardsRad,
      double spreadRad,
      long seed) {
    Arguments.requireInside("wave height [m]", heightM, 0.0, 30.0);
    Arguments.requireInside("wave period [s]", periodS, 0.5, 30.0);
    Arguments.requireFinite("wave direction [rad]", towardsRad);
    Arguments.requireInside("wave spread [rad]", spreadRad, 0.0, 1.0);
    double lengthM = Gravity.STANDARD_MPS2 * periodS * periodS / (2.0 * Math.PI);
    if (heightM > STEEPEST * lengthM) {
      throw new IllegalArgumentException(
          String.format(
              java.util.Locale.ROOT,
              "waves of %.2f m at a period of %.2f s break; expected at most %.2f m",
              heightM,
              periodS,
              STEEPEST * lengthM));
    }
    Random random = new Random(seed);
    double peak = 2.0 * Math.PI / periodS;
    int count = spectrum == Spectrum.REGULAR ? 1 : COMPONENTS;
    Waves waves = new Waves(count);
    double width = (HIGHEST - LOWEST) / count;
    double energy = 0.0;
    for (int i = 0; i < count; i++) {
      double share = count == 1 ? 1.0 : LOWEST + width * (i + random.nextDouble());
      double density = count == 1 ? 1.0 : density(share, spectrum);
      waves.amplitude[i] = StrictMath.sqrt(2.0 * density * width);
      energy += density * width;
      double towards = towardsRad + spreadRad * random.nextGaussian();
      double number = share * peak * share * peak / Gravity.STANDARD_MPS2;
      waves.frequency[i] = share * peak;
      waves.east[i] = number * StrictMath.sin(towards);
      waves.north[i] = number * StrictMath.cos(towards);
      waves.phase[i] = 2.0 * Math.PI * random.nextDouble();
    }
    // variance of the elevation: (H/4)² of a spectrum, (H/2)²/2 of one component
    double variance = heightM * heightM / (count == 1 ? 8.0 : 16.0);
    for (int i = 0; i < count; i++) {
      waves.amplitude[i] *= StrictMath.sqrt(variance / energy);
    }
    return waves;
  }

  /**
   * Spectral density over the frequency relative to the peak, up to a factor (Fossen 2021,
   * equations 10.59 and 10.71).
   */
  private static double density(double share, Spectrum spectrum) {
    double square = share * share;
    double moskowitz = StrictMath.exp(-1.25 / (square * square)) / (square * square * share);
    if (spectrum == Spectrum.PIERSON_MOSKOWITZ) {
      return moskowitz;
    }
    double off = (share - 1.0) / (share <= 1.0 ? 0.07 : 0.09);
    return moskowitz * StrictMath.pow(JONSWAP_PEAK, StrictMath.exp(-0.5 * off * off));
  }

  /**
   * Motion of the water.
   *
   * @param elevationM elevation of the surface above still water; under water, of a particle [m]
   * @param slope slope of the surface, east and north; z is 0 [1]
   * @param velocity velocity of a particle: east, north, up [m/s]
   * @param acceleration acceleration of a particle: east, north, up [m/s²]
   */
  public record Motion(double elevationM, Point slope, Point velocity, Point acceleration) {}

  /** Elevation of the surface above still water [m]. */
  public double elevationM(double eastM, double northM, double timeS) {
    return headM(eastM, northM, 0.0, timeS);
  }

  /**
   * Pressure of the waves as a head of water [m]; at the surface the elevation.
   *
   * @param depthM depth below still water, at least 0 [m]
   */
  public double headM(double eastM, double northM, double depthM, double timeS) {
    double sum = 0.0;
    for (int i = 0; i < amplitude.length; i++) {
      double angle = east[i] * eastM + north[i] * northM - frequency[i] * timeS + phase[i];
      sum += amplitude[i] * decay(i, depthM) * StrictMath.cos(angle);
    }
    return sum;
  }

  private double decay(int i, double depthM) {
    return depthM <= 0.0
        ? 1.0
        : StrictMath.exp(-frequency[i] * frequency[i] / Gravity.STANDARD_MPS2 * depthM);
  }

  /**
   * Motion of the water, averaged over a hull.
   *
   * @param depthM depth below still water [m]; above it, the surface's motion applies
   * @param lengthM hull length [m]
   * @param widthM hull width [m]
   * @param headingRad heading of the hull, clockwise from north [rad]
   */
  public Motion around(
      Point place, double depthM, double lengthM, double widthM, double headingRad, double timeS) {
    double sin = StrictMath.sin(headingRad);
    double cos = StrictMath.cos(headingRad);
    double elevation = 0.0;
    double slopeEast = 0.0;
    double slopeNorth = 0.0;
    double vEast = 0.0;
    double vNorth = 0.0;
    double vUp = 0.0;
    double aEast = 0.0;
    double aNorth = 0.0;
    double aUp = 0.0;
    for (int i = 0; i < amplitude.length; i++) {
      double w = frequency[i];
      double angle = east[i] * place.x() + north[i] * place.y() - w * timeS + phase[i];
      double size =
          amplitude[i]
              * decay(i, depthM)
              * mean(0.5 * lengthM * (east[i] * sin + north[i] * cos))
              * mean(0.5 * widthM * (east[i] * cos - north[i] * sin));
      double level = size * StrictMath.cos(angle);
      double rise = size * StrictMath.sin(angle);
      double number = w * w / Gravity.STANDARD_MPS2;
      elevation += level;
      slopeEast -= east[i] * rise;
      slopeNorth -= north[i] * rise;
      vEast += w * east[i] / number * level;
      vNorth += w * north[i] / number * level;
      vUp += w * rise;
      aEast += w * w * east[i] / number * rise;
      aNorth += w * w * north[i] / number * rise;
      aUp -= w * w * level;
    }
    return new Motion(
        elevation,
        Point.of(slopeEast, slopeNorth, 0.0),
        Point.of(vEast, vNorth, vUp),
        Point.of(aEast, aNorth, aUp));
  }

  /** Mean of a cosine over ±x, relative to its middle. */
  private static double mean(double x) {
    return Math.abs(x) < 1e-4 ? 1.0 : StrictMath.sin(x) / x;
  }
}
