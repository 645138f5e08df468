package org.u2sa.messages;

import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.frame.Rotation;
import org.u2sa.messages.frame.UtmGrid;

/**
 * Finds a chain of conversions between two frames for {@link StateInformation}, or throws if none
 * exists.
 */
final class StateConversion {
  /**
   * One step of the chain: overwrites the fields that differ in the target, a copy of the source
   * labelled with the new frame.
   */
  private interface Step {
    void convert(StateInformation from, StateInformation to);
  }

  private StateConversion() {}

  /**
   * Copy in another frame.
   *
   * @param origin of the local frames; may be null
   */
  static StateInformation convert(StateInformation state, ReferenceFrame target, Geodetic origin) {
    ReferenceFrame source = state.referenceFrame();
    if (source.equals(target)) {
      return state.copy();
    }
    if (source.isBody() && target.isBody()) {
      return step(state, target, AxisExchange::flipBody);
    }
    if (source.isLocal() && target.isLocal()) {
      return step(state, target, StateConversion::swapLocal);
    }
    if (source.isEarth() && target.isEarth()) {
      return fromGlobal(toGlobal(state), target);
    }
    if (source.isBody() || target.isBody()) {
      throw new IllegalArgumentException(
          StateTriple.between(source, target)
              + ": a StateInformation is of one family of frames; the vehicle's position and attitude"
              + " would be needed");
    }
    if (origin == null) {
      throw new IllegalArgumentException(
          StateTriple.between(source, target) + ": the position of the local origin is needed");
    }
    if (source.isEarth()) {
      StateInformation ned =
          step(
              toGlobal(state),
              ReferenceFrame.LOCAL_NED,
              (from, to) -> globalToNed(from, to, origin));
      return convert(ned, target, origin);
    }
    StateInformation ned = convert(state, ReferenceFrame.LOCAL_NED, origin);
    StateInformation global =
        step(ned, ReferenceFrame.GLOBAL, (from, to) -> nedToGlobal(from, to, origin));
    return fromGlobal(global, target);
  }

  private static StateInformation step(StateInformation from, ReferenceFrame target, Step step) {
    StateInformation to = from.copy().referenceFrame(target);
    step.convert(from, to);
    return to;
  }

  private static void swapLocal(StateInformation from, StateInformation to) {
    AxisExchange.swapPosition(from, to);
    AxisExchange.swapVectors(from, to);
    AxisExchange.swapAttitude(from, to);
  }

  private static StateInformation toGlobal(StateInformation state) {
    if (state.referenceFrame().equals(ReferenceFrame.GLOBAL)) {
      return state;
    }
    UtmGrid grid = new UtmGrid(state.referenceFrame());
    return step(
        state,
        ReferenceFrame.GLOBAL,
        (from, to) -> {
          Geodetic place = grid.place(position(from, to));
          StateTriple.POSITION.put(to, from, place.point());
          EarthRotation.fromGrid(from, to, grid, place);
        });
  }

  private static StateInformation fromGlobal(StateInformation state, ReferenceFrame target) {
    if (target.equals(ReferenceFrame.GLOBAL)) {
      return state;
    }
    UtmGrid grid = new UtmGrid(target);
    return step(
        state,
        target,
        (from, to) -> {
          Geodetic place = Geodetic.of(position(from, to));
          StateTriple.POSITION.put(to, from, grid.grid(place));
          EarthRotation.toGrid(from, to, grid, place);
        });
  }

  private static Point position(StateInformation from, StateInformation to) {
    if (!from.x().isPresent() || !from.y().isPresent()) {
      throw new IllegalArgumentException(
          StateTriple.between(from.referenceFrame(), to.referenceFrame()) + ": x and y are needed");
    }
    return StateTriple.POSITION.values(from);
  }

  /**
   * GLOBAL combines east-north-up vectors with NED attitude, so rotation and axis exchange are
   * separate steps.
   */
  private static void globalToNed(StateInformation from, StateInformation to, Geodetic origin) {
    Geodetic place = origin;
    if (!StateTriple.POSITION.isEmpty(from)) {
      Point global = position(from, to);
      place = new Geodetic(global.x(), global.y(), from.z().orElse(origin.altitudeM()));
      StateTriple.POSITION.put(to, from, origin.nedOf(place));
    }
    StateInformation turned = from.copy();
    EarthRotation.turn(from, turned, origin.enuRotationFrom(place));
    AxisExchange.swapVectors(turned, to);
    StateTriple.copyAttitude(turned, to);
  }

  private static void nedToGlobal(StateInformation from, StateInformation to, Geodetic origin) {
    Geodetic place = origin;
    if (!StateTriple.POSITION.isEmpty(from)) {
      place = origin.fromNed(position(from, to));
      StateTriple.POSITION.put(to, from, place.point());
    }
    StateInformation enu = from.copy();
    AxisExchange.swapVectors(from, enu);
    EarthRotation.turn(enu, to, place.enuRotationFrom(origin));
  }

  /**
   * Conversions that rotate east and north at the vehicle into those of a grid or a local origin.
   * The transport rate, the rotation of the axes as the vehicle moves over the earth (v/R, 40
   * µrad/s at 250 m/s), is neglected.
   */
  private static final class EarthRotation {
    private static final StateTriple[] VECTORS = {StateTriple.VELOCITY, StateTriple.ACCELERATION};
    private static final StateTriple[] SIGMAS = {
      StateTriple.POSITION_SIGMA, StateTriple.VELOCITY_SIGMA, StateTriple.ACCELERATION_SIGMA
    };

    private EarthRotation() {}

    /**
     * Converts all but the position from GLOBAL to UTM: rotates by the convergence and scales by
     * the grid's scale factor.
     */
    static void toGrid(StateInformation from, StateInformation to, UtmGrid grid, Geodetic place) {
      turnToGrid(from, to, grid.convergenceRad(place), grid.scale(place));
    }

    /** Inverse of {@link #toGrid}. */
    static void fromGrid(StateInformation from, StateInformation to, UtmGrid grid, Geodetic place) {
      turnToGrid(from, to, -grid.convergenceRad(place), 1.0 / grid.scale(place));
    }

    private static void turnToGrid(
        StateInformation from, StateInformation to, double gamma, double scale) {
      // Grid azimuth = true azimuth - γ: a rotation about up by +γ.
      Rotation turn = Rotation.aboutUp(gamma);
      turnVectors(from, to, turn, Point.of(scale, scale, 1.0));
      from.psi().ifPresent(psi -> to.psi(AxisExchange.fullTurn(psi - gamma)));
    }

    /**
     * Converts all but the position between east-north-up at the vehicle and east-north-up at an
     * origin, including attitude relative to north.
     */
    static void turn(StateInformation from, StateInformation to, Rotation enu) {
      turnVectors(from, to, enu, Point.of(1.0, 1.0, 1.0));
      turnAttitude(from, to, Rotation.NED_FROM_ENU.times(enu).times(Rotation.NED_FROM_ENU));
    }

    private static void turnVectors(
        StateInformation from, StateInformation to, Rotation enu, Point scale) {
      for (StateTriple triple : VECTORS) {
        if (!triple.isEmpty(from)) {
          triple.requirePair(from, to);
          triple.put(to, from, stretched(enu.times(triple.values(from)), scale));
        }
      }
      for (StateTriple triple : SIGMAS) {
        if (!triple.isEmpty(from)) {
          triple.requirePair(from, to);
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
}
