package org.u2sa.messages;

import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.frame.UtmGrid;

/**
 * Finds the way from one frame to another for {@link StateInformation}, step by step, and refuses
 * where there is none.
 */
final class StateConversion {
  private static final double FULL_TURN = 2.0 * Math.PI;

  /** One step puts into the target, a copy of the source in the new frame, what differs there. */
  private interface Step {
    void convert(StateInformation from, StateInformation to);
  }

  private StateConversion() {}

  /**
   * A copy in another frame.
   *
   * @param origin of the local frames; null if the caller has none
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
          between(source, target)
              + ": a StateInformation is of one family of frames; the vehicle's place and attitude"
              + " would be needed");
    }
    if (origin == null) {
      throw new IllegalArgumentException(
          between(source, target) + ": the place of the local origin is needed");
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
          between(from.referenceFrame(), to.referenceFrame()) + ": x and y are needed");
    }
    return StateTriple.POSITION.values(from);
  }

  /**
   * GLOBAL has east-north-up vectors and the attitude of NED, so that turn and exchange of axes
   * fall apart.
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

  /** "StateInformation cannot be converted from BODY to GLOBAL". */
  static String between(ReferenceFrame source, ReferenceFrame target) {
    return "StateInformation cannot be converted from " + source + " to " + target;
  }

  /** The angle within 0…2π. */
  static double fullTurn(double angle) {
    double turned = angle % FULL_TURN;
    return turned < 0.0 ? turned + FULL_TURN : turned;
  }
}
