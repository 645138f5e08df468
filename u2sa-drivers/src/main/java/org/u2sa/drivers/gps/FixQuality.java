package org.u2sa.drivers.gps;

/**
 * Fix quality from GGA's quality or RMC's mode, with the 1 σ range error [m] to assume without GST;
 * position sigma = range error × DOP.
 *
 * <p>Derived from data-sheet CEP (50 % radius) at a DOP of 1: CEP = 1.1774 σ per axis; the range
 * error is √2 σ = 1.20 CEP.
 */
enum FixQuality {
  /** GGA 1 and 3, RMC A and P: autonomous; uses the variable RANGE ERROR. */
  PLAIN(Double.POSITIVE_INFINITY),
  /** GGA 2, RMC D: differential corrections. 2.0 m CEP with SBAS (u-blox NEO-M8, UBX-15031086). */
  DIFFERENTIAL(2.4),
  /**
   * GGA 5, RMC F: RTK float. Decimetres; data sheets give no figure, so 0.5 m CEP until the fix is
   * resolved.
   */
  RTK_FLOAT(0.6),
  /**
   * GGA 4, RMC R: RTK fixed. 0.01 m + 1 ppm CEP (u-blox ZED-F9P, UBX-17051259), at a 10 km
   * baseline.
   */
  RTK_FIXED(0.024);

  private final double rangeErrorM;

  FixQuality(double rangeErrorM) {
    this.rangeErrorM = rangeErrorM;
  }

  /**
   * Range error [m], 1 σ.
   *
   * @param plainM uncorrected range error [m]; the result never exceeds it
   */
  double rangeErrorM(double plainM) {
    return Math.min(plainM, rangeErrorM);
  }
}
