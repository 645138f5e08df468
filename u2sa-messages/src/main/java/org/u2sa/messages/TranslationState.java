package org.u2sa.messages;

import java.util.OptionalDouble;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.schema.U2SAData;

/**
 * Position, velocity and acceleration over ground, with their standard deviations (figure 6, left
 * column).
 *
 * @param <S> the message class, which setters return
 */
abstract class TranslationState<S extends U2SAData> extends U2SAData {
  abstract ReferenceFrame referenceFrame();

  abstract OptionalDouble number(StateField field);

  abstract S number(StateField field, double value);

  /** Position along x [m]; longitude [deg, east +] in GLOBAL; empty if absent. */
  public OptionalDouble x() {
    return number(StateField.X);
  }

  public S x(double value) {
    return number(StateField.X, value);
  }

  /** Position along y [m]; latitude [deg, north +] in GLOBAL; empty if absent. */
  public OptionalDouble y() {
    return number(StateField.Y);
  }

  public S y(double value) {
    return number(StateField.Y, value);
  }

  /**
   * Position along z [m]; altitude above mean sea level, up +, in GLOBAL and UTM; empty if absent.
   */
  public OptionalDouble z() {
    return number(StateField.Z);
  }

  public S z(double value) {
    return number(StateField.Z, value);
  }

  /** Velocity over ground along x [m/s]; east in GLOBAL; empty if absent. */
  public OptionalDouble xDot() {
    return number(StateField.X_DOT);
  }

  public S xDot(double value) {
    return number(StateField.X_DOT, value);
  }

  /** Velocity over ground along y [m/s]; north in GLOBAL; empty if absent. */
  public OptionalDouble yDot() {
    return number(StateField.Y_DOT);
  }

  public S yDot(double value) {
    return number(StateField.Y_DOT, value);
  }

  /** Velocity along z [m/s]; up in GLOBAL and UTM; empty if absent. */
  public OptionalDouble zDot() {
    return number(StateField.Z_DOT);
  }

  public S zDot(double value) {
    return number(StateField.Z_DOT, value);
  }

  /** Acceleration along x [m/s²]; east in GLOBAL; empty if absent. */
  public OptionalDouble xDoubleDot() {
    return number(StateField.X_DOUBLE_DOT);
  }

  public S xDoubleDot(double value) {
    return number(StateField.X_DOUBLE_DOT, value);
  }

  /** Acceleration along y [m/s²]; north in GLOBAL; empty if absent. */
  public OptionalDouble yDoubleDot() {
    return number(StateField.Y_DOUBLE_DOT);
  }

  public S yDoubleDot(double value) {
    return number(StateField.Y_DOUBLE_DOT, value);
  }

  /** Acceleration along z [m/s²]; up in GLOBAL and UTM; empty if absent. */
  public OptionalDouble zDoubleDot() {
    return number(StateField.Z_DOUBLE_DOT);
  }

  public S zDoubleDot(double value) {
    return number(StateField.Z_DOUBLE_DOT, value);
  }

  /** Standard deviation of {@link #x()} [m]; in metres in GLOBAL too; empty if absent. */
  public OptionalDouble xSigma() {
    return number(StateField.X_SIGMA);
  }

  public S xSigma(double value) {
    return number(StateField.X_SIGMA, value);
  }

  /** Standard deviation of {@link #y()} [m]; in metres in GLOBAL too; empty if absent. */
  public OptionalDouble ySigma() {
    return number(StateField.Y_SIGMA);
  }

  public S ySigma(double value) {
    return number(StateField.Y_SIGMA, value);
  }

  /** Standard deviation of {@link #z()} [m]; empty if absent. */
  public OptionalDouble zSigma() {
    return number(StateField.Z_SIGMA);
  }

  public S zSigma(double value) {
    return number(StateField.Z_SIGMA, value);
  }

  /** Standard deviation of {@link #xDot()} [m/s]; empty if absent. */
  public OptionalDouble xDotSigma() {
    return number(StateField.X_DOT_SIGMA);
  }

  public S xDotSigma(double value) {
    return number(StateField.X_DOT_SIGMA, value);
  }

  /** Standard deviation of {@link #yDot()} [m/s]; empty if absent. */
  public OptionalDouble yDotSigma() {
    return number(StateField.Y_DOT_SIGMA);
  }

  public S yDotSigma(double value) {
    return number(StateField.Y_DOT_SIGMA, value);
  }

  /** Standard deviation of {@link #zDot()} [m/s]; empty if absent. */
  public OptionalDouble zDotSigma() {
    return number(StateField.Z_DOT_SIGMA);
  }

  public S zDotSigma(double value) {
    return number(StateField.Z_DOT_SIGMA, value);
  }

  /**
   * Converts in a copy the fields of a subclass that have their own axes, when changing between two
   * BODY frames.
   */
  void flipOwn(TranslationState<?> copy, BodySigns signs) {}
}
