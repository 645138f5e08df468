package org.u2sa.messages;

import java.util.OptionalDouble;
import org.u2sa.messages.schema.U2SAData;

/**
 * Motion relative to the fluid (air or water) along the vehicle's own axes (figure 6, right
 * column): those of BODY (x forward, y left, z down) unless the message itself is in BODY_FRD or
 * BODY_FLU.
 *
 * @param <S> the message class, which setters return
 */
abstract class FluidState<S extends U2SAData> extends RotationState<S> {
  /**
   * Velocity of the vehicle relative to the fluid along its own x (forward) axis [m/s]; empty if
   * absent.
   */
  public OptionalDouble fluidxDot() {
    return number(StateField.FLUID_X_DOT);
  }

  public S fluidxDot(double value) {
    return number(StateField.FLUID_X_DOT, value);
  }

  /**
   * Velocity of the vehicle relative to the fluid along its own y (left in BODY) axis [m/s]; empty
   * if absent.
   */
  public OptionalDouble fluidyDot() {
    return number(StateField.FLUID_Y_DOT);
  }

  public S fluidyDot(double value) {
    return number(StateField.FLUID_Y_DOT, value);
  }

  /**
   * Velocity of the vehicle relative to the fluid along its own z (down in BODY) axis [m/s]; empty
   * if absent.
   */
  public OptionalDouble fluidzDot() {
    return number(StateField.FLUID_Z_DOT);
  }

  public S fluidzDot(double value) {
    return number(StateField.FLUID_Z_DOT, value);
  }

  /**
   * Acceleration of the vehicle relative to the fluid along its own x (forward) axis [m/s²]; empty
   * if absent.
   */
  public OptionalDouble fluidxDoubleDot() {
    return number(StateField.FLUID_X_DOUBLE_DOT);
  }

  public S fluidxDoubleDot(double value) {
    return number(StateField.FLUID_X_DOUBLE_DOT, value);
  }

  /**
   * Acceleration of the vehicle relative to the fluid along its own y (left in BODY) axis [m/s²];
   * empty if absent.
   */
  public OptionalDouble fluidyDoubleDot() {
    return number(StateField.FLUID_Y_DOUBLE_DOT);
  }

  public S fluidyDoubleDot(double value) {
    return number(StateField.FLUID_Y_DOUBLE_DOT, value);
  }

  /**
   * Acceleration of the vehicle relative to the fluid along its own z (down in BODY) axis [m/s²];
   * empty if absent.
   */
  public OptionalDouble fluidzDoubleDot() {
    return number(StateField.FLUID_Z_DOUBLE_DOT);
  }

  public S fluidzDoubleDot(double value) {
    return number(StateField.FLUID_Z_DOUBLE_DOT, value);
  }

  /** Standard deviation of {@link #fluidxDot()} [m/s]; empty if absent. */
  public OptionalDouble fluidxDotSigma() {
    return number(StateField.FLUID_X_DOT_SIGMA);
  }

  public S fluidxDotSigma(double value) {
    return number(StateField.FLUID_X_DOT_SIGMA, value);
  }

  /** Standard deviation of {@link #fluidyDot()} [m/s]; empty if absent. */
  public OptionalDouble fluidyDotSigma() {
    return number(StateField.FLUID_Y_DOT_SIGMA);
  }

  public S fluidyDotSigma(double value) {
    return number(StateField.FLUID_Y_DOT_SIGMA, value);
  }

  /** Standard deviation of {@link #fluidzDot()} [m/s]; empty if absent. */
  public OptionalDouble fluidzDotSigma() {
    return number(StateField.FLUID_Z_DOT_SIGMA);
  }

  public S fluidzDotSigma(double value) {
    return number(StateField.FLUID_Z_DOT_SIGMA, value);
  }
}
