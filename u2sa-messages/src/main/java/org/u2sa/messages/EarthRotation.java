package org.u2sa.messages;

import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.Rotation;
import org.u2sa.messages.frame.UtmGrid;

/**
 * Conversions that turn east and north at the vehicle into those elsewhere: to a grid, or to a
 * local origin. The transport rate, by which the axes turn as the vehicle moves over the earth
 * (v/R, 40 µrad/s at 250 m/s), is left out.
 */
final class EarthRotation {
  private static final StateTriple[] VECTORS = {StateTriple.VELOCITY, StateTriple.ACCELERATION};
  private static final StateTriple[] SIGMAS = {
    StateTriple.POSITION_SIGMA, StateTriple.VELOCITY_SIGMA, StateTriple.ACCELERATION_SIGMA
  };

  private EarthRotation() {}

  /**
   * GLOBAL to UTM at a place, position apart: turned by the convergence and stretched by the grid's
   * scale.
   */
  static void toGrid(StateInformation from, StateInformation to, UtmGrid grid, Geodetic place) {
    turnToGrid(from, to, grid.convergenceRad(place), grid.scale(place));
  }

  /** The inverse of {@link #toGrid}. */
  static void fromGrid(StateInformation from, StateInformation to, UtmGrid grid, Geodetic place) {
    turnToGrid(from, to, -grid.convergenceRad(place), 1.0 / grid.scale(place));
  }

  private static void turnToGrid(
      StateInformation from, StateInformation to, double gamma, double scale) {
    // Grid azimuth = true azimuth - γ: a turn about up by +γ.
    Rotation turn = Rotation.aboutUp(gamma);
    turnVectors(from, to, turn, Point.of(scale, scale, 1.0));
    from.psi().ifPresent(psi -> to.psi(StateConversion.fullTurn(psi - gamma)));
  }

  /**
   * Between east-north-up at the vehicle and east-north-up at an origin, position apart, attitude
   * against north included.
   */
  static void turn(StateInformation from, StateInformation to, Rotation enu) {
    turnVectors(from, to, enu, Point.of(1.0, 1.0, 1.0));
    turnAttitude(from, to, Rotation.NED_FROM_ENU.times(enu).times(Rotation.NED_FROM_ENU));
  }

  private static void turnVectors(
      StateInformation from, StateInformation to, Rotation enu, Point scale) {
    String what = StateConversion.between(from.referenceFrame(), to.referenceFrame());
    for (StateTriple triple : VECTORS) {
      if (!triple.isEmpty(from)) {
        triple.requirePair(from, what);
        triple.put(to, from, stretched(enu.times(triple.values(from)), scale));
      }
    }
    for (StateTriple triple : SIGMAS) {
      if (!triple.isEmpty(from)) {
        triple.requirePair(from, what);
        triple.put(to, from, stretched(enu.timesSigma(triple.values(from)), scale));
      }
    }
  }

  private static Point stretched(Point v, Point scale) {
    return Point.of(v.x() * scale.x(), v.y() * scale.y(), v.z() * scale.z());
  }

  private static void turnAttitude(StateInformation from, StateInformation to, Rotation ned) {
    if (StateTriple.ANGLES.isEmpty(from)) {
      return;
    }
    Point angles = StateTriple.ANGLES.values(from);
    Attitude before = new Attitude(angles.x(), angles.y(), angles.z());
    Attitude after = Attitude.of(ned.times(before.nedFromFrd()));
    StateTriple.ANGLES.put(to, from, Point.of(after.phi(), after.theta(), after.psi()));
    if (!StateTriple.ANGLES.isComplete(from) || !StateTriple.RATES.isComplete(from)) {
      return;
    }
    Point rates = StateTriple.RATES.values(from);
    Point ratesAfter = after.eulerRates(before.bodyRates(rates));
    StateTriple.RATES.put(to, from, ratesAfter);
    if (StateTriple.ANGULAR_ACCELERATIONS.isComplete(from)) {
      // d/dt of ω = W(E) Ė on both sides: W' Ë' + Ẇ' Ė' = W Ë + Ẇ Ė.
      Point body =
          before
              .bodyRates(StateTriple.ANGULAR_ACCELERATIONS.values(from))
              .plus(before.bodyRatesDrift(rates));
      StateTriple.ANGULAR_ACCELERATIONS.put(
          to, from, after.eulerRates(body.minus(after.bodyRatesDrift(ratesAfter))));
    }
  }
}
