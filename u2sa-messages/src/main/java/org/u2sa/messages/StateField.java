package org.u2sa.messages;

/**
 * The 48 optional numbers of {@link StateInformation} in the order of figure 6, column by column:
 * the ordinal is the presence bit. Append only. See the getter of the same name, if any, for
 * meaning, unit and sign.
 */
public enum StateField {
  X("x", "m"),
  Y("y", "m"),
  Z("z", "m"),
  X_DOT("xDot", "m/s"),
  Y_DOT("yDot", "m/s"),
  Z_DOT("zDot", "m/s"),
  X_DOUBLE_DOT("xDoubleDot", "m/s2"),
  Y_DOUBLE_DOT("yDoubleDot", "m/s2"),
  Z_DOUBLE_DOT("zDoubleDot", "m/s2"),
  X_SIGMA("xSigma", "m"),
  Y_SIGMA("ySigma", "m"),
  Z_SIGMA("zSigma", "m"),
  X_DOT_SIGMA("xDotSigma", "m/s"),
  Y_DOT_SIGMA("yDotSigma", "m/s"),
  Z_DOT_SIGMA("zDotSigma", "m/s"),
  /** Standard deviation of {@link StateInformation#xDoubleDot()} [m/s²]; empty if absent. */
  X_DOUBLE_DOT_SIGMA("xDoubleDotSigma", "m/s2"),
  /** Standard deviation of {@link StateInformation#yDoubleDot()} [m/s²]; empty if absent. */
  Y_DOUBLE_DOT_SIGMA("yDoubleDotSigma", "m/s2"),
  /** Standard deviation of {@link StateInformation#zDoubleDot()} [m/s²]; empty if absent. */
  Z_DOUBLE_DOT_SIGMA("zDoubleDotSigma", "m/s2"),
  PHI("phi", "rad"),
  THETA("theta", "rad"),
  PSI("psi", "rad"),
  PHI_DOT("phiDot", "rad/s"),
  THETA_DOT("thetaDot", "rad/s"),
  PSI_DOT("psiDot", "rad/s"),
  PHI_DOUBLE_DOT("phiDoubleDot", "rad/s2"),
  THETA_DOUBLE_DOT("thetaDoubleDot", "rad/s2"),
  PSI_DOUBLE_DOT("psiDoubleDot", "rad/s2"),
  PHI_SIGMA("phiSigma", "rad"),
  THETA_SIGMA("thetaSigma", "rad"),
  PSI_SIGMA("psiSigma", "rad"),
  PHI_DOT_SIGMA("phiDotSigma", "rad/s"),
  THETA_DOT_SIGMA("thetaDotSigma", "rad/s"),
  PSI_DOT_SIGMA("psiDotSigma", "rad/s"),
  /** Standard deviation of {@link StateInformation#phiDoubleDot()} [rad/s²]; empty if absent. */
  PHI_DOUBLE_DOT_SIGMA("phiDoubleDotSigma", "rad/s2"),
  /** Standard deviation of {@link StateInformation#thetaDoubleDot()} [rad/s²]; empty if absent. */
  THETA_DOUBLE_DOT_SIGMA("thetaDoubleDotSigma", "rad/s2"),
  /** Standard deviation of {@link StateInformation#psiDoubleDot()} [rad/s²]; empty if absent. */
  PSI_DOUBLE_DOT_SIGMA("psiDoubleDotSigma", "rad/s2"),
  FLUID_X_DOT("fluidxDot", "m/s"),
  FLUID_Y_DOT("fluidyDot", "m/s"),
  FLUID_Z_DOT("fluidzDot", "m/s"),
  FLUID_X_DOUBLE_DOT("fluidxDoubleDot", "m/s2"),
  FLUID_Y_DOUBLE_DOT("fluidyDoubleDot", "m/s2"),
  FLUID_Z_DOUBLE_DOT("fluidzDoubleDot", "m/s2"),
  FLUID_X_DOT_SIGMA("fluidxDotSigma", "m/s"),
  FLUID_Y_DOT_SIGMA("fluidyDotSigma", "m/s"),
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
