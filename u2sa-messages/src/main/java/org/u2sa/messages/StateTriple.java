package org.u2sa.messages;

import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;

/**
 * Three fields of {@link StateInformation} that form a vector or a set of angles, for conversions.
 */
enum StateTriple {
  POSITION(StateField.X),
  VELOCITY(StateField.X_DOT),
  ACCELERATION(StateField.X_DOUBLE_DOT),
  POSITION_SIGMA(StateField.X_SIGMA),
  VELOCITY_SIGMA(StateField.X_DOT_SIGMA),
  ACCELERATION_SIGMA(StateField.X_DOUBLE_DOT_SIGMA),
  ANGLES(StateField.PHI),
  RATES(StateField.PHI_DOT),
  ANGULAR_ACCELERATIONS(StateField.PHI_DOUBLE_DOT),
  FLUID_VELOCITY(StateField.FLUID_X_DOT),
  FLUID_ACCELERATION(StateField.FLUID_X_DOUBLE_DOT),
  FLUID_VELOCITY_SIGMA(StateField.FLUID_X_DOT_SIGMA),
  FLUID_ACCELERATION_SIGMA(StateField.FLUID_X_DOUBLE_DOT_SIGMA);

  private final StateField[] fields = new StateField[3];

  StateTriple(StateField first) {
    for (int i = 0; i < fields.length; i++) {
      fields[i] = StateField.values()[first.ordinal() + i];
    }
  }

  /** Copies attitude and its derivatives from {@code source} unchanged. */
  static void copyAttitude(TranslationState<?> source, TranslationState<?> target) {
    for (StateTriple triple : new StateTriple[] {ANGLES, RATES, ANGULAR_ACCELERATIONS}) {
      triple.put(target, source, triple.values(source));
    }
  }

  boolean isEmpty(TranslationState<?> state) {
    return state.number(fields[0]).isEmpty()
        && state.number(fields[1]).isEmpty()
        && state.number(fields[2]).isEmpty();
  }

  boolean isComplete(TranslationState<?> state) {
    return state.number(fields[0]).isPresent()
        && state.number(fields[1]).isPresent()
        && state.number(fields[2]).isPresent();
  }

  /** The three values, with 0 for absent ones. */
  Point values(TranslationState<?> state) {
    return Point.of(
        state.number(fields[0]).orElse(0.0),
        state.number(fields[1]).orElse(0.0),
        state.number(fields[2]).orElse(0.0));
  }

  /** Copies the fields that are present in {@code source}. */
  void put(TranslationState<?> state, TranslationState<?> source, Point values) {
    double[] put = {values.x(), values.y(), values.z()};
    for (int i = 0; i < put.length; i++) {
      if (source.number(fields[i]).isPresent()) {
        state.number(fields[i], put[i]);
      }
    }
  }

  /**
   * Rejects a first value without the second and vice versa, because the axes mix.
   *
   * @param to named in the error
   */
  void requirePair(TranslationState<?> from, TranslationState<?> to) {
    if (from.number(fields[0]).isPresent() != from.number(fields[1]).isPresent()) {
      throw new IllegalArgumentException(
          String.format(
              "%s: expected both %s and %s, or neither",
              between(from.referenceFrame(), to.referenceFrame()),
              fields[0].fieldName(),
              fields[1].fieldName()));
    }
  }

  /** "StateInformation cannot be converted from BODY to GLOBAL". */
  static String between(ReferenceFrame source, ReferenceFrame target) {
    return "StateInformation cannot be converted from " + source + " to " + target;
  }
}
