package org.u2sa.estimation;

import org.u2sa.messages.frame.Gravity;
import org.u2sa.messages.frame.Point;

/**
 * Recognises the reading of a blocked pitot tube. The pressure trapped in it stays the same, so
 * v²/2 of the reading grows by g with each metre of climb. That of an aircraft in flight does so
 * for a few metres at most.
 */
final class TrappedPressure {
  private static final double SAME_M = 4.0; // range of levels that count as the same
  private static final double CHANGE_M = 10.0; // of altitude, within which flight shows

  private double levelM;
  private double lowestM = Double.NaN; // level since it was last another
  private double highestM = Double.NaN;
  private double bottomM; // altitude since then
  private double topM;
  private Point windBefore = Point.ORIGIN;

  /**
   * Adds a reading [m/s] at an altitude [m].
   *
   * @param wind average known at present
   */
  void see(double readMps, double altitudeM, Point wind) {
    levelM = readMps * readMps / (2.0 * Gravity.STANDARD_MPS2) - altitudeM;
    lowestM = Math.min(lowestM, levelM);
    highestM = Math.max(highestM, levelM);
    bottomM = Math.min(bottomM, altitudeM);
    topM = Math.max(topM, altitudeM);
    boolean isSame = highestM - lowestM < SAME_M; // false for NaN
    if (!isSame) {
      lowestM = levelM;
      highestM = levelM;
      bottomM = altitudeM;
      topM = altitudeM;
      windBefore = wind;
    }
  }

  /** The pressure in the tube, if it is blocked, as a height: v²/2g less the altitude [m]. */
  double levelM() {
    return levelM;
  }

  /** Whether the readings have been those of a blocked tube over a change of altitude. */
  boolean isLikely() {
    return topM - bottomM > CHANGE_M;
  }

  /** The wind known before that. */
  Point windBefore() {
    return windBefore;
  }
}
