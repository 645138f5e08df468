package org.u2sa.control.fixedwing;

import java.util.Optional;
import org.u2sa.control.Transfer;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;

/** State machine of {@link FlightPhase}s. */
final class TakeOffSequence {
  /** Transition thresholds of the phases. */
  record Variables(
      @Variable(unit = "rpm", min = 0, max = 2000, ifAbsent = 600)
          @Description("Engine speed above which the engine counts as running.")
          double readyRpm,
      @Variable(unit = "s", min = 0, max = 60, ifAbsent = 1)
          @Description("Time that engine and navigation must be ready before the throttle opens.")
          double readyTime,
      @Variable(min = 0.1, max = 1, ifAbsent = 0.5)
          @Description("Throttle at which the brakes are released.")
          double releaseThrottle,
      @Variable(unit = "kt", min = 10, max = 80, ifAbsent = 55)
          @Description("Calibrated rotation speed.")
          double rotationSpeed,
      @Variable(unit = "m", min = 5, max = 500, ifAbsent = 100)
          @Description("Height above ground at which the climb-out ends.")
          double safeHeight) {}

  private static final double FLYING_HEIGHT_M = 15.0; // wheels at this height mean flying
  private static final double LIFTED_FOR_S = 0.3; // shorter lift-offs are hops
  private static final double LANDED_FOR_S = 1.0;
  private static final double STANDS_MPS = 1.0;
  private static final double MAX_TAIL_WIND_MPS = 15.0; // more means a wrong airspeed

  private final Variables parameters;
  private final double rotationMps; // in calm air
  private FlightPhase phase;
  private boolean isArmed = true;
  private double readySinceS = Double.NaN;
  private double liftedSinceS = Double.NaN;
  private double landedSinceS = Double.NaN;

  TakeOffSequence(Variables parameters) {
    this.parameters = parameters;
    rotationMps = AutopilotVariables.KNOT_MPS * parameters.rotationSpeed();
  }

  void transfer(Transfer state) {
    readySinceS = state.number("READY SINCE", readySinceS, Double.NaN);
    liftedSinceS = state.number("LIFTED SINCE", liftedSinceS, Double.NaN);
    landedSinceS = state.number("LANDED SINCE", landedSinceS, Double.NaN);
    phase = state.constant("PHASE", FlightPhase.class, phase);
  }

  /** Current phase; empty before the first step. */
  Optional<FlightPhase> phase() {
    return Optional.ofNullable(phase);
  }

  /** Disarmed, it neither begins nor continues a take-off run, and at rest it is ready for one. */
  void armed(boolean now) {
    isArmed = now;
  }

  /**
   * @param navigating whether navigation is present and fresh
   * @param landing whether it leads to the ground, and the ground is near
   * @param refused whether landing is refused
   * @param rotateMps calibrated airspeed at which the nose is raised
   * @param throttle last throttle command, 0…1
   */
  FlightPhase step(
      FlightState state,
      boolean navigating,
      boolean landing,
      boolean refused,
      double rotateMps,
      double throttle) {
    liftedSinceS = since(liftedSinceS, !state.onGround(), state.timeS());
    landedSinceS = since(landedSinceS, state.onGround(), state.timeS());
    readySinceS = since(readySinceS, engineReady(state) && navigating, state.timeS());
    FlightPhase flying =
        !navigating ? FlightPhase.HOLD : refused ? FlightPhase.GO_AROUND : FlightPhase.CRUISE;
    if (phase == null && !navigating && !isHigh(state)) {
      // not known yet whether it takes off or lands
      return isSlow(state) ? FlightPhase.RUN_UP : FlightPhase.HOLD;
    }
    phase = next(state, flying, landing && !refused, rotateMps, throttle);
    return phase;
  }

  private static boolean isHigh(FlightState state) {
    return !state.onGround() && state.heightM() > FLYING_HEIGHT_M;
  }

  private boolean isSlow(FlightState state) {
    return state.calibratedAirspeedMps() < rotationMps;
  }

  private FlightPhase next(
      FlightState state, FlightPhase flying, boolean landing, double rotateMps, double throttle) {
    boolean high = isHigh(state);
    if (phase == null) {
      return high ? flying : first(state, landing);
    }
    return switch (phase) {
      case RUN_UP -> {
        boolean open = isArmed && cleared(state) && throttle >= parameters.releaseThrottle();
        yield high ? flying : open ? FlightPhase.ROLL : FlightPhase.RUN_UP;
      }
      case ROLL -> {
        if (state.calibratedAirspeedMps() >= rotateMps) {
          yield FlightPhase.ROTATE;
        }
        // Disarmed, or without navigation, power or airspeed, reject it while braking is possible.
        boolean isLed = isArmed && flying != FlightPhase.HOLD;
        boolean isSensed = state.groundSpeedMps() - state.trueAirspeedMps() < MAX_TAIL_WIND_MPS;
        yield isLed && isSensed && state.engineRpm() >= parameters.readyRpm()
            ? FlightPhase.ROLL
            : FlightPhase.STOPPED;
      }
      case ROTATE ->
          lasting(liftedSinceS, state, LIFTED_FOR_S) ? FlightPhase.CLIMB_OUT : FlightPhase.ROTATE;
      case CLIMB_OUT -> state.heightM() >= parameters.safeHeight() ? flying : FlightPhase.CLIMB_OUT;
      case CRUISE, HOLD, GO_AROUND -> {
        boolean landed = lasting(landedSinceS, state, LANDED_FOR_S) && isSlow(state);
        yield landed ? FlightPhase.STOPPED : landing ? FlightPhase.FLARE : flying;
      }
      case FLARE -> {
        boolean landed = lasting(landedSinceS, state, LANDED_FOR_S);
        yield landed ? FlightPhase.STOPPED : high ? flying : FlightPhase.FLARE;
      }
      case STOPPED -> {
        boolean again = !isArmed && state.groundSpeedMps() < STANDS_MPS;
        yield high ? flying : again ? FlightPhase.RUN_UP : FlightPhase.STOPPED;
      }
    };
  }

  /**
   * Initial phase of a control system started near the ground: brakes and idle if the aircraft is
   * at rest or too slow to fly, for good if it rolls out.
   */
  private FlightPhase first(FlightState state, boolean landing) {
    if (isSlow(state)) {
      boolean rollsOut = landing && state.onGround() && state.groundSpeedMps() > STANDS_MPS;
      return rollsOut ? FlightPhase.STOPPED : FlightPhase.RUN_UP;
    }
    if (landing) {
      return state.onGround() ? FlightPhase.STOPPED : FlightPhase.FLARE;
    }
    return state.onGround() ? FlightPhase.ROTATE : FlightPhase.CLIMB_OUT;
  }

  /** Whether the engine runs on its own. */
  boolean engineReady(FlightState state) {
    return state.engineRpm() >= parameters.readyRpm() && !state.engineStarting();
  }

  /** Whether engine and navigation have been ready long enough to open the throttle. */
  boolean cleared(FlightState state) {
    return lasting(readySinceS, state, parameters.readyTime());
  }

  private static boolean lasting(double sinceS, FlightState state, double forS) {
    return state.timeS() - sinceS >= forS; // false for NaN
  }

  private static double since(double sinceS, boolean now, double timeS) {
    if (!now) {
      return Double.NaN;
    }
    return Double.isNaN(sinceS) ? timeS : sinceS;
  }
}
