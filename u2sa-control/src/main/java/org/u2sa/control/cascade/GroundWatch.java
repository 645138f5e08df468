package org.u2sa.control.cascade;

/**
 * Determines whether an aircraft is on the ground, where it must not lift its weight. It counts as
 * airborne once its target is above it or it moves vertically, and as landed when the ground
 * carries weight: it is commanded to sink, its lift is reduced, and it does not gain the speed that
 * the missing lift would give it. Neither noise in the measured velocity nor wind that pushes it
 * along the ground hides this. An aircraft that lies on its side has crashed: it stays down. Not
 * thread-safe.
 */
final class GroundWatch {
  private static final double ABOVE_M = 0.3; // minimum height of a target that implies taking off
  private static final double MOVES_MPS = 1.0; // vertically
  private static final double SINKS_MPS = 0.1; // minimum wanted sink rate
  private static final double SINKS_SHARE = 0.5; // fraction of the wanted sink rate, in flight
  private static final double STANDS_MPS = 1.5; // missing speed that implies standing
  private static final double USUAL_S = 1.0;
  private static final double FORGETS_S = 0.5; // gusts and lag of the rotors
  private static final double SURE_S = 1.0;

  private boolean stands = true;
  private double usualMps2; // of the commanded acceleration in steady flight: error of the mass
  private double missingMps;
  private double beforeMps;
  private double hinderedS; // time for which it has not sunk as wanted
  private double liesS; // time for which it has been on its side without falling

  /**
   * Processes a step.
   *
   * @param toGoDownM vertical distance to the target, down positive [m]; 0 without one
   * @param wantedDownMps wanted vertical speed [m/s]
   * @param downMps vertical speed [m/s]
   * @param attainedMps2 vertical acceleration that lift and gravity would give, down positive
   * @param isOnSide whether it leans more than any flight requires
   */
  void step(
      double toGoDownM,
      double wantedDownMps,
      double downMps,
      double attainedMps2,
      boolean isOnSide,
      double stepS) {
    double gainedMps = downMps - beforeMps;
    beforeMps = downMps;
    boolean isSteady = Math.abs(downMps) <= MOVES_MPS;
    liesS = isOnSide && isSteady ? liesS + stepS : 0.0;
    if (stands && (isOnSide || toGoDownM >= -ABOVE_M && isSteady)) {
      return;
    }
    if (stands) {
      flies();
    }
    missingMps += (attainedMps2 - usualMps2) * stepS - gainedMps;
    missingMps -= Math.min(1.0, stepS / FORGETS_S) * missingMps;
    if (wantedDownMps < SINKS_MPS || downMps > SINKS_SHARE * wantedDownMps) {
      usualMps2 += Math.min(1.0, stepS / USUAL_S) * (attainedMps2 - usualMps2);
      hinderedS = 0.0;
    } else {
      hinderedS += stepS;
    }
    stands = hinderedS > SURE_S && missingMps > STANDS_MPS || liesS > SURE_S;
  }

  boolean stands() {
    return stands;
  }

  /** Called in flight, and when a law takes over in flight. */
  void flies() {
    stands = false;
    missingMps = 0.0;
    hinderedS = 0.0;
    liesS = 0.0;
  }

  /** Called when the vehicle was disarmed. */
  void rest() {
    stands = true;
    usualMps2 = 0.0;
  }
}
