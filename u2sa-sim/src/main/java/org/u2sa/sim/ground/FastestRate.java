package org.u2sa.sim.ground;

import java.util.Locale;

/**
 * Upper bound of the rates at which a ground vehicle settles or oscillates, with the loads and
 * commands of one tick. It tells into how many steps the tick has to be divided: wheels of a few
 * grams settle much faster than a tick.
 */
final class FastestRate {
  /** Product of rate and step up to which a tick is one step; Runge-Kutta is stable up to 2.78. */
  private static final double STABLE = 2.5;

  /** The product in a divided tick: accurate, also where reversing doubles the rate of friction. */
  private static final double ACCURATE = 0.5;

  private static final int MAX_STEPS = 200;

  private final double massKg;
  private final double yawInertiaKgM2;
  private double body; // [1/s]
  private double bodySquare; // [1/s²]
  private double wheel;
  private double wheelSquare;

  FastestRate(double massKg, double yawInertiaKgM2) {
    this.massKg = massKg;
    this.yawInertiaKgM2 = yawInertiaKgM2;
  }

  void begin() {
    body = 0.0;
    bodySquare = 0.0;
    wheel = 0.0;
    wheelSquare = 0.0;
  }

  /** Adds a driven wheel with the body's motion on its tyre. */
  void add(DrivenWheel each, double spin) {
    wheel = Math.max(wheel, each.settlingPerS(spin));
    wheelSquare = Math.max(wheelSquare, each.squaredPerS2());
    add(each.x, each.y, each.springNPerM(), each.damperNsPerM());
    body += each.scrubNms() / yawInertiaKgM2;
  }

  /** Adds a tyre at a position relative to the centre of gravity. */
  void add(double x, double y, double springNPerM, double damperNsPerM) {
    double perKg = 1.0 / massKg + (x * x + y * y) / yawInertiaKgM2;
    body += damperNsPerM * perKg;
    bodySquare += springNPerM * perKg;
  }

  /** Adds a state that settles by itself. */
  void add(double perS) {
    wheel = Math.max(wheel, perS);
  }

  /**
   * Number of equal steps for a stable tick.
   *
   * @throws IllegalArgumentException if there would be too many
   */
  int steps(double tickS) {
    double perS = Math.max(wheel + body, StrictMath.sqrt(wheelSquare + bodySquare));
    double product = perS * tickS;
    double steps = product <= STABLE ? 1.0 : Math.ceil(product / ACCURATE);
    if (!(steps <= MAX_STEPS)) {
      throw new IllegalArgumentException(
          String.format(
              Locale.ROOT,
              "its wheels and tyres settle within %.1e s, too fast for the simulator: are masses, inertias, radii and relaxation length in the right units?",
              1.0 / perS));
    }
    return (int) steps;
  }
}
