package org.u2sa.control.cascade;

import org.u2sa.control.Pid;

/**
 * Keeps the compensation of wind and current pointing where it did while a vessel turns. Wind and
 * current push in a direction of the earth, but the integrals of surge and sway are along the
 * vessel's axes: unturned, after a U-turn they push with the current.
 *
 * <p>On a straight way, the sway integral is the push from abeam. The surge integral is mostly the
 * vessel's own drag, which turns with it, so the push from ahead is what earlier headings showed;
 * it is forgotten slowly. While the vessel turns, its sway integral is mostly due to the turn.
 */
final class SteadyPush {
  private static final double MEMORY_S = 30.0;
  private static final double LEARNS_IN_S = 3.0;
  private static final double STRAIGHT_RAD_PER_S = 0.1;
  private static final double LONGEST_STEP_S = 1.0;

  private double psiRad = Double.NaN; // of the last step
  private double ahead; // compensation along the vessel's axes [m/s²]
  private double abeam;

  /** Turns the integrals by the change of heading since the last call. */
  void turn(Pid surge, Pid sway, double newPsiRad, double stepS) {
    boolean continues = stepS > 0.0 && stepS <= LONGEST_STEP_S && !Double.isNaN(psiRad);
    double by = continues ? Math.IEEEremainder(newPsiRad - psiRad, 2.0 * Math.PI) : 0.0;
    psiRad = newPsiRad;
    double cos = StrictMath.cos(by);
    double sin = StrictMath.sin(by);
    double x = ahead * cos + abeam * sin;
    double y = abeam * cos - ahead * sin;
    surge.disturb(x - ahead);
    sway.disturb(y - abeam);
    ahead = x * Math.exp(-stepS / MEMORY_S);
    abeam = y;
    if (continues && Math.abs(by) < STRAIGHT_RAD_PER_S * stepS) {
      abeam += Math.min(1.0, stepS / LEARNS_IN_S) * (sway.integral() - abeam);
    }
  }

  void rest() {
    psiRad = Double.NaN;
    ahead = 0.0;
    abeam = 0.0;
  }
}
