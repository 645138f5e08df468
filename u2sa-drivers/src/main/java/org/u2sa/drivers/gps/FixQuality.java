package org.u2sa.drivers.gps;

/**
 * How a position came about, as GGA's quality or RMC's mode says it, and what error of the distance
 * to a satellite [m], 1 σ, that stands for where the receiver sends no GST: times the dilution of
 * precision it is the position's.
 *
 * <p>From data sheets' CEP, the radius that holds half of the errors, at a dilution of 1: CEP =
 * 1.1774 σ of an axis, and the range error is √2 of that, 1.20 CEP.
 */
enum FixQuality {
  /** GGA 1 and 3, RMC A and P: satellites alone; that of the variable RANGE ERROR. */
  PLAIN(Double.POSITIVE_INFINITY),
  /** GGA 2, RMC D: corrected codes. 2.0 m CEP with SBAS (u-blox NEO-M8, UBX-15031086). */
  DIFFERENTIAL(2.4),
  /**
   * GGA 5, RMC F: carrier phases, ambiguities not solved. Decimetres; data sheets name no figure:
   * 0.5 m CEP, until it is fixed.
   */
  RTK_FLOAT(0.6),
  /**
   * GGA 4, RMC R: carrier phases, ambiguities solved. 0.01 m + 1 ppm CEP (u-blox ZED-F9P,
   * UBX-17051259), with the base 10 km away.
   */
  RTK_FIXED(0.024);

  private final double rangeErrorM;

  FixQuality(double rangeErrorM) {
    this.rangeErrorM = rangeErrorM;
  }

  /**
   * Error of a distance to a satellite [m], 1 σ.
   *
   * @param plainM that of the receiver without any correction [m]; no correction makes it worse
   */
  double rangeErrorM(double plainM) {
    return Math.min(plainM, rangeErrorM);
  }
}
