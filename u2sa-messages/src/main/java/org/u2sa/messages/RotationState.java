package org.u2sa.messages;

import java.util.OptionalDouble;
import org.u2sa.messages.schema.U2SAData;

/**
 * Attitude, its rates and accelerations, with their standard deviations (figure 6, middle column).
 * Signs follow the frame's conventions.
 *
 * @param <S> the message class, which setters return
 */
abstract class RotationState<S extends U2SAData> extends TranslationState<S> {
  /** Roll [rad]; right wing down positive in GLOBAL; empty if absent. */
  public OptionalDouble phi() {
    return number(StateField.PHI);
  }

  public S phi(double value) {
    return number(StateField.PHI, value);
  }

  /** Pitch [rad]; nose up positive in GLOBAL; empty if absent. */
  public OptionalDouble theta() {
    return number(StateField.THETA);
  }

  public S theta(double value) {
    return number(StateField.THETA, value);
  }

  /** Heading [rad]; clockwise from true north, 0…2π, in GLOBAL; empty if absent. */
  public OptionalDouble psi() {
    return number(StateField.PSI);
  }

  public S psi(double value) {
    return number(StateField.PSI, value);
  }

  /** Roll rate (Euler angle) [rad/s]; empty if absent. */
  public OptionalDouble phiDot() {
    return number(StateField.PHI_DOT);
  }

  public S phiDot(double value) {
    return number(StateField.PHI_DOT, value);
  }

  /** Pitch rate (Euler angle) [rad/s]; empty if absent. */
  public OptionalDouble thetaDot() {
    return number(StateField.THETA_DOT);
  }

  public S thetaDot(double value) {
    return number(StateField.THETA_DOT, value);
  }

  /** Heading rate (Euler angle) [rad/s]; empty if absent. */
  public OptionalDouble psiDot() {
    return number(StateField.PSI_DOT);
  }

  public S psiDot(double value) {
    return number(StateField.PSI_DOT, value);
  }

  /** Roll acceleration (Euler angle) [rad/s²]; empty if absent. */
  public OptionalDouble phiDoubleDot() {
    return number(StateField.PHI_DOUBLE_DOT);
  }

  public S phiDoubleDot(double value) {
    return number(StateField.PHI_DOUBLE_DOT, value);
  }

  /** Pitch acceleration (Euler angle) [rad/s²]; empty if absent. */
  public OptionalDouble thetaDoubleDot() {
    return number(StateField.THETA_DOUBLE_DOT);
  }

  public S thetaDoubleDot(double value) {
    return number(StateField.THETA_DOUBLE_DOT, value);
  }

  /** Heading acceleration (Euler angle) [rad/s²]; empty if absent. */
  public OptionalDouble psiDoubleDot() {
    return number(StateField.PSI_DOUBLE_DOT);
  }

  public S psiDoubleDot(double value) {
    return number(StateField.PSI_DOUBLE_DOT, value);
  }

  /** Standard deviation of {@link #phi()} [rad]; empty if absent. */
  public OptionalDouble phiSigma() {
    return number(StateField.PHI_SIGMA);
  }

  public S phiSigma(double value) {
    return number(StateField.PHI_SIGMA, value);
  }

  /** Standard deviation of {@link #theta()} [rad]; empty if absent. */
  public OptionalDouble thetaSigma() {
    return number(StateField.THETA_SIGMA);
  }

  public S thetaSigma(double value) {
    return number(StateField.THETA_SIGMA, value);
  }

  /** Standard deviation of {@link #psi()} [rad]; empty if absent. */
  public OptionalDouble psiSigma() {
    return number(StateField.PSI_SIGMA);
  }

  public S psiSigma(double value) {
    return number(StateField.PSI_SIGMA, value);
  }

  /** Standard deviation of {@link #phiDot()} [rad/s]; empty if absent. */
  public OptionalDouble phiDotSigma() {
    return number(StateField.PHI_DOT_SIGMA);
  }

  public S phiDotSigma(double value) {
    return number(StateField.PHI_DOT_SIGMA, value);
  }

  /** Standard deviation of {@link #thetaDot()} [rad/s]; empty if absent. */
  public OptionalDouble thetaDotSigma() {
    return number(StateField.THETA_DOT_SIGMA);
  }

  public S thetaDotSigma(double value) {
    return number(StateField.THETA_DOT_SIGMA, value);
  }

  /** Standard deviation of {@link #psiDot()} [rad/s]; empty if absent. */
  public OptionalDouble psiDotSigma() {
    return number(StateField.PSI_DOT_SIGMA);
  }

  public S psiDotSigma(double value) {
    return number(StateField.PSI_DOT_SIGMA, value);
  }
}
