package org.u2sa.messages;

/**
 * The 48 optional numbers of {@link StateInformation} in the order of figure 6, column by column:
 * the ordinal is the presence bit. Append only.
 */
public enum StateField {
  /** Position along x [m]; longitude [deg, east +] in GLOBAL. */
  X("x", "m"),
  /** Position along y [m]; latitude [deg, north +] in GLOBAL. */
  Y("y", "m"),
  /** Position along z [m]; altitude above mean sea level, up +, in GLOBAL and UTM. */
  Z("z", "m"),
  /** Velocity over ground along x [m/s]; east in GLOBAL. */
  X_DOT("xDot", "m/s"),
  /** Velocity over ground along y [m/s]; north in GLOBAL. */
  Y_DOT("yDot", "m/s"),
  /** Velocity along z [m/s]; up in GLOBAL and UTM. */
  Z_DOT("zDot", "m/s"),
  /** Acceleration along x [m/s²]; east in GLOBAL. */
  X_DOUBLE_DOT("xDoubleDot", "m/s2"),
  /** Acceleration along y [m/s²]; north in GLOBAL. */
  Y_DOUBLE_DOT("yDoubleDot", "m/s2"),
  /** Acceleration along z [m/s²]; up in GLOBAL and UTM. */
  Z_DOUBLE_DOT("zDoubleDot", "m/s2"),
  /** Standard deviation of {@link StateInformation#x()} [m]; in metres in GLOBAL too. */
  X_SIGMA("xSigma", "m"),
  /** Standard deviation of {@link StateInformation#y()} [m]; in metres in GLOBAL too. */
  Y_SIGMA("ySigma", "m"),
  /** Standard deviation of {@link StateInformation#z()} [m]. */
  Z_SIGMA("zSigma", "m"),
  /** Standard deviation of {@link StateInformation#xDot()} [m/s]. */
  X_DOT_SIGMA("xDotSigma", "m/s"),
  /** Standard deviation of {@link StateInformation#yDot()} [m/s]. */
  Y_DOT_SIGMA("yDotSigma", "m/s"),
  /** Standard deviation of {@link StateInformation#zDot()} [m/s]. */
  Z_DOT_SIGMA("zDotSigma", "m/s"),
  /** Standard deviation of {@link StateInformation#xDoubleDot()} [m/s²]; empty if absent. */
  X_DOUBLE_DOT_SIGMA("xDoubleDotSigma", "m/s2"),
  /** Standard deviation of {@link StateInformation#yDoubleDot()} [m/s²]; empty if absent. */
  Y_DOUBLE_DOT_SIGMA("yDoubleDotSigma", "m/s2"),
  /** Standard deviation of {@link StateInformation#zDoubleDot()} [m/s²]; empty if absent. */
  Z_DOUBLE_DOT_SIGMA("zDoubleDotSigma", "m/s2"),
  /** Roll [rad]; right wing down positive in GLOBAL. */
  PHI("phi", "rad"),
  /** Pitch [rad]; nose up positive in GLOBAL. */
  THETA("theta", "rad"),
  /** Heading [rad]; clockwise from true north, 0…2π, in GLOBAL. */
  PSI("psi", "rad"),
  /** Roll rate (Euler angle) [rad/s]. */
  PHI_DOT("phiDot", "rad/s"),
  /** Pitch rate (Euler angle) [rad/s]. */
  THETA_DOT("thetaDot", "rad/s"),
  /** Heading rate (Euler angle) [rad/s]. */
  PSI_DOT("psiDot", "rad/s"),
  /** Roll acceleration (Euler angle) [rad/s²]. */
  PHI_DOUBLE_DOT("phiDoubleDot", "rad/s2"),
  /** Pitch acceleration (Euler angle) [rad/s²]. */
  THETA_DOUBLE_DOT("thetaDoubleDot", "rad/s2"),
  /** Heading acceleration (Euler angle) [rad/s²]. */
  PSI_DOUBLE_DOT("psiDoubleDot", "rad/s2"),
  /** Standard deviation of {@link StateInformation#phi()} [rad]. */
  PHI_SIGMA("phiSigma", "rad"),
  /** Standard deviation of {@link StateInformation#theta()} [rad]. */
  THETA_SIGMA("thetaSigma", "rad"),
  /** Standard deviation of {@link StateInformation#psi()} [rad]. */
  PSI_SIGMA("psiSigma", "rad"),
  /** Standard deviation of {@link StateInformation#phiDot()} [rad/s]. */
  PHI_DOT_SIGMA("phiDotSigma", "rad/s"),
  /** Standard deviation of {@link StateInformation#thetaDot()} [rad/s]. */
  THETA_DOT_SIGMA("thetaDotSigma", "rad/s"),
  /** Standard deviation of {@link StateInformation#psiDot()} [rad/s]. */
  PSI_DOT_SIGMA("psiDotSigma", "rad/s"),
  /** Standard deviation of {@link StateInformation#phiDoubleDot()} [rad/s²]; empty if absent. */
  PHI_DOUBLE_DOT_SIGMA("phiDoubleDotSigma", "rad/s2"),
  /** Standard deviation of {@link StateInformation#thetaDoubleDot()} [rad/s²]; empty if absent. */
  THETA_DOUBLE_DOT_SIGMA("thetaDoubleDotSigma", "rad/s2"),
  /** Standard deviation of {@link StateInformation#psiDoubleDot()} [rad/s²]; empty if absent. */
  PSI_DOUBLE_DOT_SIGMA("psiDoubleDotSigma", "rad/s2"),
  /** Velocity of the vehicle relative to the fluid along its own x (forward) axis [m/s]. */
  FLUID_X_DOT("fluidxDot", "m/s"),
  /** Velocity of the vehicle relative to the fluid along its own y (left in BODY) axis [m/s]. */
  FLUID_Y_DOT("fluidyDot", "m/s"),
  /** Velocity of the vehicle relative to the fluid along its own z (down in BODY) axis [m/s]. */
  FLUID_Z_DOT("fluidzDot", "m/s"),
  /** Acceleration of the vehicle relative to the fluid along its own x (forward) axis [m/s²]. */
  FLUID_X_DOUBLE_DOT("fluidxDoubleDot", "m/s2"),
  /**
   * Acceleration of the vehicle relative to the fluid along its own y (left in BODY) axis [m/s²].
   */
  FLUID_Y_DOUBLE_DOT("fluidyDoubleDot", "m/s2"),
  /**
   * Acceleration of the vehicle relative to the fluid along its own z (down in BODY) axis [m/s²].
   */
  FLUID_Z_DOUBLE_DOT("fluidzDoubleDot", "m/s2"),
  /** Standard deviation of {@link StateInformation#fluidxDot()} [m/s]. */
  FLUID_X_DOT_SIGMA("fluidxDotSigma", "m/s"),
  /** Standard deviation of {@link StateInformation#fluidyDot()} [m/s]. */
  FLUID_Y_DOT_SIGMA("fluidyDotSigma", "m/s"),
  /** Standard deviation of {@link StateInformation#fluidzDot()} [m/s]. */
  FLUID_Z_DOT_SIGMA("fluidzDotSigma", "m/s"),
  /** Standard deviation of {@link StateInformation#fluidxDoubleDot()} [m/s²]; empty if absent. */
  FLUID_X_DOUBLE_DOT_SIGMA("fluidxDoubleDotSigma", "m/s2"),
  /** Standard deviation of {@link StateInformation#fluidyDoubleDot()} [m/s²]; empty if absent. */
  FLUID_Y_DOUBLE_DOT_SIGMA("fluidyDoubleDotSigma", "m/s2"),
  /** Standard deviation of {@link StateInformation#fluidzDoubleDot()} [m/s²]; empty if absent. */
  FLUID_Z_DOUBLE_DOT_SIGMA("fluidzDoubleDotSigma", "m/s2");

  private final String fieldName;
  private final String unit;

  StateField(String fieldName, String unit) {
    this.fieldName = fieldName;
    this.unit = unit;
  }

  /** The field's name, as in figure 6. */
  public String fieldName() {
    return fieldName;
  }

  /** The field's unit; x and y are in degrees in GLOBAL. */
  public String unit() {
    return unit;
  }
}
