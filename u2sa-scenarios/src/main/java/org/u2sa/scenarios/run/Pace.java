package org.u2sa.scenarios.run;

/**
 * How long a run may take: who is slower never arrives.
 *
 * @param readyWithinS to get ready [s]
 * @param slowestMps mean speed along the mission's legs [m/s]
 */
public record Pace(double readyWithinS, double slowestMps) {

  /** For legs of that length together [s]. */
  double limitS(double lengthM) {
    return readyWithinS + lengthM / slowestMps;
  }
}
