package org.u2sa.sim.ground;

import org.u2sa.sim.motion.Arguments;

/** A battery with voltage sag and limited charge. */
final class Battery {
  private static final double S_PER_H = 3600.0;

  private final BatteryParameters p;
  private double charge = 1.0;
  private double volts;
  private double givenJ;

  Battery(BatteryParameters parameters) {
    this.p = parameters;
    this.volts = open() - p.idleA() * p.resistanceOhm();
  }

  void charge(double newCharge) {
    charge = Arguments.requireInside("charge", newCharge, 0.0, 1.0);
    volts = open() - p.idleA() * p.resistanceOhm();
  }

  /**
   * Terminal voltage with two motors connected. Each draws duty · (duty · V − EMF) / R, so V solves
   * a linear equation. An open motor counts as duty 0, because a shorted (braking) motor draws no
   * battery current either.
   *
   * @param perOhm 1 / R of a motor, 0 if absent [1/Ω]
   */
  double volts(
      double duty1, double emf1, double perOhm1, double duty2, double emf2, double perOhm2) {
    double drawn = duty1 * duty1 * perOhm1 + duty2 * duty2 * perOhm2;
    double given = duty1 * emf1 * perOhm1 + duty2 * emf2 * perOhm2;
    double r = p.resistanceOhm();
    volts = Math.max(0.0, (open() + r * (given - p.idleA())) / (1.0 + r * drawn));
    return volts;
  }

  /** Removes the charge of a current [A] over a time [s]; negative when motors regenerate. */
  void draw(double motorsA, double dtS) {
    double taken = (motorsA + p.idleA()) * dtS / (p.capacityAh() * S_PER_H);
    charge = Math.max(0.0, Math.min(1.0, charge - taken));
    givenJ += volts * (motorsA + p.idleA()) * dtS;
  }

  double volts() {
    return volts;
  }

  /** Energy drawn at the terminals so far, less the energy fed back by motors [J]. */
  double givenJ() {
    return givenJ;
  }

  double charge() {
    return charge;
  }

  private double open() {
    return charge == 0.0 ? 0.0 : p.emptyV() + charge * (p.fullV() - p.emptyV());
  }
}
