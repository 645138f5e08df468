package org.u2sa.control.fixedwing;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.control.Transfer;

/**
 * Flies an aeroplane from the runway along its mission: state and navigation in, surfaces out. Pure
 * computation: time comes with the state. Not thread-safe.
 */
public final class Autopilot {
  private static final double LONGEST_STEP_S = 0.2; // a longer gap is a lost link, not a step
  private static final double SHORTEST_STEP_S = 1e-3;
  private static final double GLIDE_SINK_MPS = 3.0; // above this sink rate the flare starts earlier
  private static final double SOONER_S = 1.0;

  private final AutopilotVariables tuning;
  private final TakeOffSequence sequence;
  private final GroundSteering steering;
  private final InnerLoops loops;
  private final AirbornePhases air;
  private final TouchDown touchDown;
  private final WindEstimate wind = new WindEstimate();
  private final FinalApproach approach = new FinalApproach();
  private final LandingRefusal refusal;
  private final TouchDown.ContactWatch contact = new TouchDown.ContactWatch();

  private FlightPhase phase = FlightPhase.RUN_UP;
  private boolean isArmed = true;
  private boolean takenOver; // taken over from another law: the throttle must not jump
  private double lastTimeS = Double.NaN;
  private double navigatedS; // when navigation was last present

  Autopilot(AutopilotVariables tuning) {
    this.tuning = tuning;
    sequence = new TakeOffSequence(tuning.takeOff());
    steering = new GroundSteering(tuning.ground());
    loops = new InnerLoops(tuning);
    air = new AirbornePhases(tuning, steering, loops, wind);
    touchDown = new TouchDown(tuning.touchDown(), tuning.flare(), steering, loops);
    refusal =
        new LandingRefusal(
            tuning.touchDown().maxCrosswind(), tuning.takeOff().safeHeight(), touchDown.heightM());
  }

  /** Whether the vehicle is armed: otherwise no take-off begins. */
  void armed(boolean now) {
    isArmed = now;
    sequence.armed(now);
  }

  /**
   * Computes one step.
   *
   * @param target empty if navigation is absent or stale
   */
  Surfaces step(FlightState seen, Optional<GuidanceTarget> target) {
    boolean first = Double.isNaN(lastTimeS);
    double dtS =
        first
            ? SHORTEST_STEP_S
            : Limit.within(SHORTEST_STEP_S, seen.timeS() - lastTimeS, LONGEST_STEP_S);
    lastTimeS = seen.timeS();
    contact.step(seen, phase, wantedSinkMps(seen, target), dtS);
    FlightState state = contact.isOnGround() ? seen.onWheels() : seen;
    FlightPhase before = phase;
    if (first || target.isPresent()) {
      navigatedS = state.timeS();
    }
    wind.step(state, dtS);
    if (phase != FlightPhase.FLARE && phase != FlightPhase.STOPPED) {
      target.ifPresent(ahead -> approach.see(state, ahead, dtS));
    }
    phase =
        sequence.step(
            state,
            target.isPresent(),
            isLanding(state, target) || contact.isHindered(),
            refusal.step(state, target, wind, approach),
            tuning.rotationMps(wind),
            loops.throttle());
    if (first || phase != before) {
      enter(state, before, first);
    }
    return switch (phase) {
      case RUN_UP -> runUp(state, target.isPresent(), dtS);
      case ROLL, ROTATE -> run(state, phase == FlightPhase.ROTATE, dtS);
      case CLIMB_OUT -> air.climbOut(state, dtS);
      case CRUISE, HOLD -> air.fly(state, target, isLost(state), dtS);
      case GO_AROUND -> air.goAround(state, target.orElseThrow(), dtS);
      case FLARE -> touchDown.flare(state, dtS);
      case STOPPED -> touchDown.rollOut(state, dtS);
    };
  }

  private Surfaces runUp(FlightState state, boolean navigating, double dtS) {
    steering.lineUp(state);
    double wanted = 0.0;
    if (!sequence.engineReady(state)) {
      wanted = tuning.climbOut().startThrottle();
    } else if (isArmed && navigating && sequence.cleared(state)) {
      wanted = 1.0;
    }
    loops.throttleTowards(wanted, dtS);
    loops.rudder(0.0);
    return new Surfaces(steering.aileron(state), 0.0, 0.0, loops.throttle(), 1.0, 0.0, 1.0);
  }

  /**
   * @param rotating whether to raise the nose
   */
  private Surfaces run(FlightState state, boolean rotating, double dtS) {
    loops.throttleTowards(1.0, dtS);
    loops.rudder(steering.rudder(state, !rotating, dtS));
    double elevator = 0.0;
    double level = 0.0;
    if (rotating) {
      double step = Math.toRadians(tuning.climbOut().rotationRate()) * dtS;
      double pitch = Limit.approach(loops.pitchRad(), tuning.rotationPitchRad(wind), step);
      loops.pitch(Math.min(pitch, tuning.guidance().pitchLimitRad(state)));
      elevator = loops.elevator(state, dtS);
      level = loops.levelAileron(state, dtS);
    }
    double aileron = Limit.symmetric(steering.aileron(state) + level, 1.0);
    return new Surfaces(aileron, elevator, loops.rudder(), loops.throttle(), 1.0, 0.0, 0.0);
  }

  private boolean isLost(FlightState state) {
    return state.timeS() - navigatedS > tuning.hold().holdLevelTime();
  }

  private boolean isLanding(FlightState state, Optional<GuidanceTarget> target) {
    double sooner = SOONER_S * Math.max(0.0, -state.climbMps() - GLIDE_SINK_MPS);
    return state.heightM() < touchDown.heightM() + sooner && isLedDown(state, target);
  }

  private static boolean isLedDown(FlightState state, Optional<GuidanceTarget> target) {
    double groundM = state.altitudeM() - state.heightM();
    return target
        .filter(point -> point.altitudeM() - groundM < LandingRefusal.LEADS_DOWN_M)
        .isPresent();
  }

  /** Sink rate that a landing demands [m/s]; 0 without one. */
  private double wantedSinkMps(FlightState state, Optional<GuidanceTarget> target) {
    return switch (phase) {
      case CRUISE -> isLedDown(state, target) ? air.wantedSinkMps() : 0.0;
      case FLARE -> touchDown.wantedSinkMps(state);
      default -> 0.0;
    };
  }

  private void enter(FlightState state, FlightPhase before, boolean first) {
    if (first || phase == FlightPhase.HOLD) {
      air.holdHere(state);
    }
    boolean airborne =
        phase == FlightPhase.CRUISE || phase == FlightPhase.HOLD || phase == FlightPhase.GO_AROUND;
    boolean begins =
        first || (airborne && (before == FlightPhase.RUN_UP || before == FlightPhase.STOPPED));
    if (begins && (airborne || phase == FlightPhase.CLIMB_OUT)) {
      loops.throttle(takenOver ? loops.throttle() : tuning.energy().throttleTrim());
      takenOver = false;
    }
    if (first) {
      loops.pitch(state.pitchRad());
      air.arrest();
    }
    if (airborne && begins) {
      loops.hold(state.rollRad());
      air.restartEnergy(state, state.pitchRad());
    }
    switch (phase) {
      case ROTATE -> loops.pitch(state.pitchRad());
      case CLIMB_OUT -> {
        loops.hold(0.0);
        loops.restartYaw();
        air.restartEnergy(state, loops.pitchRad());
      }
      case FLARE -> {
        contact.begin();
        touchDown.begin(state, approach);
      }
      case ROLL -> loops.restart();
      default -> {
        // nothing begins there
      }
    }
  }

  /** Saves or restores the complete state. */
  void transfer(Transfer state) {
    lastTimeS = state.number("LAST TIME", lastTimeS, Double.NaN);
    navigatedS = state.number("NAVIGATED", navigatedS, lastTimeS);
    sequence.transfer(state);
    phase = sequence.phase().orElse(phase);
    steering.transfer(state);
    loops.transfer(state);
    air.transfer(state);
    touchDown.transfer(state);
    wind.transfer(state);
    approach.transfer(state);
    refusal.transfer(state);
    contact.transfer(state);
  }

  /**
   * Starts in the air from another control law's commands, shares of full as in {@link Surfaces}.
   */
  void takeOver(double aileron, double elevator, double lastRudder, double lastThrottle) {
    loops.takeOver(aileron, elevator, lastRudder, lastThrottle);
    takenOver = true;
  }

  /** Reason for the go-around. */
  String refusalWords() {
    return refusal.words();
  }

  /** Calibrated airspeed to which the wind has raised the demand [m/s]; empty if it has not. */
  OptionalDouble raisedToMps() {
    boolean follows = phase == FlightPhase.CRUISE || phase == FlightPhase.GO_AROUND;
    return follows && air.raisedToMps() > 0.0
        ? OptionalDouble.of(air.raisedToMps())
        : OptionalDouble.empty();
  }

  /** Wind speed, gusts averaged [m/s]. */
  double windMps() {
    return wind.speedMps();
  }

  FlightPhase phase() {
    return phase;
  }

  /** Bank demanded [rad]. */
  double bankDemandRad() {
    return loops.bankRad();
  }

  /** Pitch demanded [rad]. */
  double pitchDemandRad() {
    return loops.pitchRad();
  }

  /** Altitude demanded, above mean sea level [m]. */
  double altitudeDemandM() {
    return air.altitudeDemandM();
  }

  /** Calibrated airspeed demanded [m/s]. */
  double speedDemandMps() {
    return air.speedDemandMps();
  }
}
