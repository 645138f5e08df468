package org.u2sa.messages;

import org.u2sa.messages.frame.Point;

/**
 * Conversions that only swap axes and flip signs: LOCAL_ENU ↔ LOCAL_NED, and among the BODY frames.
 */
final class AxisExchange {
  private static final double QUARTER = Math.PI / 2.0;
  private static final double FULL_TURN = 2.0 * Math.PI;

  private AxisExchange() {}

  /**
   * Converts the position between LOCAL_ENU and LOCAL_NED, either way: swaps x and y and negates z.
   */
  static void swapPosition(TranslationState<?> from, TranslationState<?> to) {
    swap(StateTriple.POSITION, from, to, -1.0);
  }

  /**
   * Converts velocities, accelerations and all standard deviations between east-north-up and
   * north-east-down, either way.
   */
  static void swapVectors(TranslationState<?> from, TranslationState<?> to) {
    swap(StateTriple.VELOCITY, from, to, -1.0);
    swap(StateTriple.ACCELERATION, from, to, -1.0);
    swap(StateTriple.POSITION_SIGMA, from, to, 1.0);
    swap(StateTriple.VELOCITY_SIGMA, from, to, 1.0);
    swap(StateTriple.ACCELERATION_SIGMA, from, to, 1.0);
  }

  /**
   * Converts attitude between FRD relative to NED and FLU relative to ENU, either way: same roll,
   * negated pitch, and a heading of π/2 - ψ. Derivatives follow; standard deviations are unchanged.
   */
  static void swapAttitude(RotationState<?> from, RotationState<?> to) {
    from.theta().ifPresent(theta -> to.theta(-theta));
    from.psi().ifPresent(psi -> to.psi(fullTurn(QUARTER - psi)));
    flip(StateTriple.RATES, from, to, 1.0, -1.0, -1.0);
    flip(StateTriple.ANGULAR_ACCELERATIONS, from, to, 1.0, -1.0, -1.0);
  }

  /** Wraps an angle into 0…2π. */
  static double fullTurn(double angle) {
    double turned = angle % FULL_TURN;
    return turned < 0.0 ? turned + FULL_TURN : turned;
  }

  private static void swap(
      StateTriple triple, TranslationState<?> from, TranslationState<?> to, double zSign) {
    triple.requirePair(from, to);
    Point v = triple.values(from);
    triple.put(to, from, Point.of(v.y(), v.x(), zSign * v.z()));
  }

  /**
   * Converts between two BODY frames: negates y or z or both, and the senses of rotation with them.
   */
  static void flipBody(TranslationState<?> from, TranslationState<?> to) {
    BodySigns signs = BodySigns.between(from.referenceFrame(), to.referenceFrame());
    for (StateTriple triple :
        new StateTriple[] {
          StateTriple.POSITION,
          StateTriple.VELOCITY,
          StateTriple.ACCELERATION,
          StateTriple.FLUID_VELOCITY,
          StateTriple.FLUID_ACCELERATION
        }) {
      flip(triple, from, to, 1.0, signs.y(), signs.z());
    }
    for (StateTriple triple :
        new StateTriple[] {
          StateTriple.ANGLES, StateTriple.RATES, StateTriple.ANGULAR_ACCELERATIONS
        }) {
      flip(triple, from, to, signs.phi(), signs.theta(), signs.psi());
    }
    from.flipOwn(to, signs);
  }

  private static void flip(
      StateTriple triple,
      TranslationState<?> from,
      TranslationState<?> to,
      double first,
      double second,
      double third) {
    Point v = triple.values(from);
    triple.put(to, from, Point.of(first * v.x(), second * v.y(), third * v.z()));
  }
}
