package org.u2sa.sim.atmosphere;

import java.util.Random;

/**
 * Continuous gusts with the Dryden spectra of MIL-F-8785C, 3.7.1.2 and 3.7.3, as shaping filters
 * driven by white noise. Signs of the rotary gusts follow MIL-HDBK-1797. Up to 1000 ft the
 * intensities and scales of the low-altitude model apply, and from 2000 ft a scale of 1750 ft, with
 * linear interpolation in between; above 1000 ft the intensity stays constant (the specification
 * uses a table of exceedance probabilities instead).
 *
 * <p>The filters are discretised exactly, so variance and spectrum do not depend on the step.
 */
public final class DrydenGusts {
  private static final double FOOT_M = 0.3048;
  private static final double LOWEST_FT = 10.0; // the low-altitude model starts here
  private static final double LOW_FT = 1_000.0;
  private static final double HIGH_FT = 2_000.0;
  private static final double HIGH_SCALE_FT = 1_750.0;
  private static final double SLOWEST_MPS =
      3.0; // minimum speed: turbulence drifts past a stationary aircraft with the wind

  private final double sigmaVerticalMps;
  private final double spanM;
  private final Random noise;
  private final SecondOrder lateral = new SecondOrder();
  private final SecondOrder vertical = new SecondOrder();
  private double longitudinal; // unit variance
  private double roll; // unit variance
  private double laggedLateralMps;
  private double laggedVerticalMps;

  private double forwardMps;
  private double rightMps;
  private double downMps;
  private double rollRadPerS;
  private double pitchRadPerS;
  private double yawRadPerS;

  /**
   * @param sigmaVerticalMps root mean square of the vertical gusts below 1000 ft [m/s]
   * @param spanM wing span of the aircraft [m], above 0
   */
  public DrydenGusts(double sigmaVerticalMps, double spanM, long seed) {
    if (!(sigmaVerticalMps >= 0.0 && spanM > 0.0)) {
      throw new IllegalArgumentException(
          "gusts need sigma ≥ 0 and span > 0, got "
              + sigmaVerticalMps
              + " m/s and "
              + spanM
              + " m");
    }
    this.sigmaVerticalMps = sigmaVerticalMps;
    this.spanM = spanM;
    this.noise = new Random(seed);
  }

  /**
   * Advances the gusts by one step.
   *
   * @param dtS time step [s], above 0
   * @param heightM height above ground [m]
   * @param airspeedMps true airspeed [m/s]
   */
  public void step(double dtS, double heightM, double airspeedMps) {
    if (sigmaVerticalMps == 0.0) {
      return;
    }
    double heightFt = Math.max(LOWEST_FT, heightM / FOOT_M);
    double speed = Math.max(SLOWEST_MPS, airspeedMps);
    double shape = 0.177 + 0.000823 * Math.min(heightFt, LOW_FT); // 1 at 1000 ft
    double above = Math.min(1.0, Math.max(0.0, (heightFt - LOW_FT) / (HIGH_FT - LOW_FT)));
    double scaleHigh = LOW_FT + (HIGH_SCALE_FT - LOW_FT) * above;
    double lowHeight = Math.min(heightFt, LOW_FT);
    double scaleW = FOOT_M * (heightFt < LOW_FT ? lowHeight : scaleHigh);
    double scaleU =
        FOOT_M * (heightFt < LOW_FT ? lowHeight / StrictMath.pow(shape, 1.2) : scaleHigh);
    double sigmaU = sigmaVerticalMps / StrictMath.pow(shape, 0.4);

    longitudinal = firstOrder(longitudinal, speed * dtS / scaleU);
    forwardMps = sigmaU * longitudinal;
    rightMps = sigmaU * lateral.step(speed * dtS / scaleU, noise);
    downMps = sigmaVerticalMps * vertical.step(speed * dtS / scaleW, noise);

    // σp² = σw² · 0.8/V · (π/4b)^{1/3} / Lw^{2/3} · π/2 · πV/4b: variance under MIL-F-8785C's
    // spectrum of p
    double rollCorner = Math.PI * speed / (4.0 * spanM);
    double sigmaP =
        sigmaVerticalMps
            * StrictMath.sqrt(0.8 * Math.PI / speed * rollCorner / 2.0)
            * StrictMath.pow(Math.PI / (4.0 * spanM), 1.0 / 6.0)
            / StrictMath.cbrt(scaleW);
    roll = firstOrder(roll, rollCorner * dtS);
    rollRadPerS = sigmaP * roll;

    double yawCorner = Math.PI * speed / (3.0 * spanM);
    pitchRadPerS = -(downMps - laggedVerticalMps) * rollCorner / speed;
    yawRadPerS = (rightMps - laggedLateralMps) * yawCorner / speed;
    laggedVerticalMps += (downMps - laggedVerticalMps) * (1.0 - StrictMath.exp(-rollCorner * dtS));
    laggedLateralMps += (rightMps - laggedLateralMps) * (1.0 - StrictMath.exp(-yawCorner * dtS));
  }

  private double firstOrder(double state, double delta) {
    double keep = StrictMath.exp(-delta);
    return keep * state + StrictMath.sqrt(1.0 - keep * keep) * noise.nextGaussian();
  }

  /** Velocity of the air along the aircraft's heading [m/s]. */
  public double forwardMps() {
    return forwardMps;
  }

  /** Velocity of the air to the right of the heading [m/s]. */
  public double rightMps() {
    return rightMps;
  }

  /** Velocity of the air downwards [m/s]. */
  public double downMps() {
    return downMps;
  }

  /** Rotation of the air about the aircraft's forward axis [rad/s]. */
  public double rollRadPerS() {
    return rollRadPerS;
  }

  /** Rotation of the air about the aircraft's right axis [rad/s]. */
  public double pitchRadPerS() {
    return pitchRadPerS;
  }

  /** Rotation of the air about the aircraft's down axis [rad/s]. */
  public double yawRadPerS() {
    return yawRadPerS;
  }

  /** (1 + √3 τs) / (1 + τs)² driven by white noise, scaled to unit variance; time counted in τ. */
  private static final class SecondOrder {
    private static final double ROOT3 = StrictMath.sqrt(3.0);
    private double first;
    private double second;

    double step(double delta, Random noise) {
      double keep = StrictMath.exp(-delta);
      double keep2 = keep * keep;
      double q11 = (1.0 - keep2) / 2.0;
      double q12 = 0.25 - keep2 * (0.5 * delta + 0.25);
      double q22 = 0.25 - keep2 * (0.5 * delta * delta + 0.5 * delta + 0.25);
      double l11 = StrictMath.sqrt(q11);
      double l21 = q12 / l11;
      double l22 = StrictMath.sqrt(Math.max(0.0, q22 - l21 * l21));
      double n1 = noise.nextGaussian();
      double n2 = noise.nextGaussian();
      second = keep * (second + delta * first) + l21 * n1 + l22 * n2;
      first = keep * first + l11 * n1;
      return ROOT3 * first + (1.0 - ROOT3) * second;
    }
  }
}
