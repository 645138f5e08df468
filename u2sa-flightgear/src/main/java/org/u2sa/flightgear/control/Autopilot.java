package org.u2sa.flightgear.control;

import java.util.Optional;
import org.u2sa.service.HandOver;

/**
 * Flies the Cessna from the runway along its mission: state and navigation in, surfaces out. Pure
 * computation: time comes with the state. Not safe for several threads.
 */
final class Autopilot {
  private static final double LONGEST_STEP_S = 0.2; // a longer gap is a lost link, not a step
  private static final double SHORTEST_STEP_S = 1e-3;
  private static final double LEAST_SCALE = 0.6;
  private static final double MOST_SCALE = 1.6;
  private static final double NEAR_GROUND_M = 10.0;
  private static final double AT_GROUND_M = 3.0; // who is led below this above ground is to land
  private static final double FLARE_BANK_RAD = Math.toRadians(8.0); // more would touch a wing
  private static final double ROLLING_MPS = 2.0;
  private static final double RUDDER_RATE =
      2.0; // full travel a second is half a second stop to stop

  private final Tuning tuning;
  private final TakeOffSequence sequence;
  private final GroundSteering ground;
  private final LateralGuidance lateral;
  private final StallGuard stall;
  private final RollLaw roll;
  private final PitchLaw pitch;
  private final YawLaw yaw;
  private final EnergyLaw energy;
  private final FlareLaw flare;

  private FlightPhase phase = FlightPhase.RUN_UP;
  private boolean takenOver; // the throttle is another law's, and not to jump
  private double lastTimeS = Double.NaN;
  private double navigatedS; // when there was navigation last
  private double throttle;
  private double rudder;
  private double bankDemand;
  private double pitchDemand;
  private double holdAltitudeM;
  private double altitudeDemandM;
  private double speedDemandMps; // calibrated

  Autopilot(Tuning tuning) {
    this.tuning = tuning;
    this.sequence = new TakeOffSequence(tuning.takeOff());
    this.ground = new GroundSteering(tuning.ground());
    this.lateral = new LateralGuidance(tuning.shortestL1M());
    this.stall = new StallGuard(tuning.stall());
    this.roll = new RollLaw(tuning.roll());
    this.pitch = new PitchLaw(tuning.pitch());
    this.yaw = new YawLaw(tuning.yaw());
    this.energy = new EnergyLaw(tuning.energy());
    this.flare = new FlareLaw(tuning.flare());
    this.speedDemandMps = tuning.cruiseMps();
  }

  /**
   * One step.
   *
   * @param target empty if navigation is absent or stale
   */
  Surfaces step(FlightState state, Optional<GuidanceTarget> target) {
    double dtS =
        Double.isNaN(lastTimeS)
            ? SHORTEST_STEP_S
            : Limit.within(SHORTEST_STEP_S, state.timeS() - lastTimeS, LONGEST_STEP_S);
    boolean first = Double.isNaN(lastTimeS);
    lastTimeS = state.timeS();
    FlightPhase before = phase;
    if (first || target.isPresent()) {
      navigatedS = state.timeS();
    }
    phase = sequence.step(state, target.isPresent(), isLanding(state, target), throttle);
    if (first || phase != before) {
      enter(state, before, first);
    }
    return switch (phase) {
      case RUN_UP -> runUp(state, target.isPresent(), dtS);
      case ROLL, ROTATE -> run(state, dtS);
      case CLIMB_OUT -> climbOut(state, dtS);
      case CRUISE, HOLD -> fly(state, target, dtS);
      case FLARE -> touchDown(state, target, dtS);
      case STOPPED -> stop(state, dtS);
    };
  }

  private boolean isLanding(FlightState state, Optional<GuidanceTarget> target) {
    double groundM = state.altitudeM() - state.heightM();
    return state.heightM() < flare.heightM()
        && target.filter(point -> point.altitudeM() - groundM < AT_GROUND_M).isPresent();
  }

  /** Writes down all that it remembers, for one that takes over. */
  void handOver(HandOver state) {
    state
        .number("LAST TIME", lastTimeS)
        .number("NAVIGATED", navigatedS)
        .number("THROTTLE", throttle)
        .number("RUDDER", rudder)
        .number("BANK DEMAND", bankDemand)
        .number("PITCH DEMAND", pitchDemand)
        .number("HOLD ALTITUDE", holdAltitudeM)
        .number("ALTITUDE DEMAND", altitudeDemandM)
        .number("SPEED DEMAND", speedDemandMps);
    sequence.handOver(state);
    ground.handOver(state);
    roll.handOver(state);
    pitch.handOver(state);
    yaw.handOver(state);
    energy.handOver(state);
    flare.handOver(state);
  }

  /** Goes on exactly where another one was. */
  void takeOver(HandOver state) {
    sequence.takeOver(state);
    phase = state.text("PHASE").map(FlightPhase::valueOf).orElse(phase);
    lastTimeS = state.number("LAST TIME").orElse(Double.NaN);
    navigatedS = state.number("NAVIGATED").orElse(lastTimeS);
    throttle = state.number("THROTTLE").orElse(0.0);
    rudder = state.number("RUDDER").orElse(0.0);
    bankDemand = state.number("BANK DEMAND").orElse(0.0);
    pitchDemand = state.number("PITCH DEMAND").orElse(0.0);
    holdAltitudeM = state.number("HOLD ALTITUDE").orElse(0.0);
    altitudeDemandM = state.number("ALTITUDE DEMAND").orElse(0.0);
    speedDemandMps = state.number("SPEED DEMAND").orElse(tuning.cruiseMps());
    ground.takeOver(state);
    roll.takeOver(state);
    pitch.takeOver(state);
    yaw.takeOver(state);
    energy.takeOver(state);
    flare.takeOver(state);
  }

  /** Begins in the air from what another control law commanded, shares of full as in Surfaces. */
  void takeOver(double aileron, double elevator, double lastRudder, double lastThrottle) {
    roll.restart(aileron);
    pitch.restart(elevator);
    yaw.restart(lastRudder);
    rudder = lastRudder;
    throttle = lastThrottle;
    takenOver = true;
  }

  private void enter(FlightState state, FlightPhase before, boolean first) {
    if (first || phase == FlightPhase.HOLD) {
      holdAltitudeM =
          Math.max(
              state.altitudeM(),
              state.altitudeM() - state.heightM() + tuning.takeOff().safeHeightM());
    }
    boolean airborne = phase == FlightPhase.CRUISE || phase == FlightPhase.HOLD;
    if (airborne && (first || before == FlightPhase.RUN_UP || before == FlightPhase.STOPPED)) {
      throttle = takenOver ? throttle : tuning.energy().throttleTrim();
      takenOver = false;
      bankDemand = state.rollRad();
      energy.restart(state, state.pitchRad(), throttle);
    }
    if (phase == FlightPhase.ROTATE) {
      pitchDemand = state.pitchRad();
    } else if (phase == FlightPhase.CLIMB_OUT) {
      bankDemand = 0.0;
      yaw.restart(rudder);
      energy.restart(state, pitchDemand, throttle);
    } else if (phase == FlightPhase.FLARE) {
      flare.restart(pitchDemand);
    } else if (phase == FlightPhase.ROLL) {
      pitch.restart();
      roll.restart();
    }
  }

  private Surfaces runUp(FlightState state, boolean navigating, double dtS) {
    ground.lineUp(state);
    double wanted = 0.0;
    if (!sequence.engineReady(state)) {
      wanted = tuning.climbOut().startThrottle();
    } else if (navigating && sequence.cleared(state)) {
      wanted = 1.0;
    }
    throttle = Limit.approach(throttle, wanted, tuning.climbOut().throttleRate() * dtS);
    rudder = 0.0;
    return new Surfaces(ground.aileron(state), 0.0, 0.0, throttle, 1.0, 0.0, 1.0);
  }

  private Surfaces run(FlightState state, double dtS) {
    throttle = Limit.approach(throttle, 1.0, tuning.climbOut().throttleRate() * dtS);
    boolean rotating = phase == FlightPhase.ROTATE;
    rudder = ground.rudder(state, !rotating, dtS);
    double elevator = 0.0;
    if (rotating) {
      Tuning.ClimbOut climb = tuning.climbOut();
      pitchDemand = Limit.approach(pitchDemand, climb.rotatePitchRad(), climb.rotateRate() * dtS);
      elevator = pitch.elevator(state, pitchDemand, scale(state), dtS);
    }
    double level = rotating ? roll.aileron(state, 0.0, scale(state), dtS) : 0.0;
    double aileron = Limit.symmetric(ground.aileron(state) + level, 1.0);
    return new Surfaces(aileron, elevator, rudder, throttle, 1.0, 0.0, 0.0);
  }

  private Surfaces climbOut(FlightState state, double dtS) {
    Tuning.ClimbOut climb = tuning.climbOut();
    double look = climb.lookAheadM();
    double bank =
        lateral.bankRad(state, ground.aheadNorthM(state, look), ground.aheadEastM(state, look));
    altitudeDemandM = state.altitudeM() - state.heightM() + tuning.takeOff().safeHeightM();
    speedDemandMps = climb.speedMps();
    // Near the ground the nose stays where it was raised to, whatever the airspeed asks for.
    double low = Limit.within(0.0, 2.0 - state.heightM() / NEAR_GROUND_M, 1.0);
    double least =
        climb.leastPitchRad() + low * Math.max(0.0, climb.rotatePitchRad() - climb.leastPitchRad());
    return surfaces(state, bank, climb.bankLimitRad(), true, least, dtS);
  }

  private Surfaces fly(FlightState state, Optional<GuidanceTarget> target, double dtS) {
    boolean circles = state.timeS() - navigatedS > tuning.hold().levelS();
    double bank = circles ? tuning.hold().bankRad() : 0.0;
    altitudeDemandM = holdAltitudeM;
    speedDemandMps = tuning.cruiseMps();
    if (target.isPresent()) {
      GuidanceTarget ahead = target.get();
      bank = lateral.bankRad(state, ahead.northM(), ahead.eastM());
      altitudeDemandM = ahead.altitudeM();
      speedDemandMps =
          ahead.speedMps().orElse(speedDemandMps * state.trueOverCalibrated())
              / state.trueOverCalibrated();
      holdAltitudeM = altitudeDemandM;
    }
    return surfaces(state, bank, tuning.bankLimitRad(), false, tuning.leastPitchRad(), dtS);
  }

  private Surfaces surfaces(
      FlightState state,
      double bank,
      double bankLimit,
      boolean speedOnly,
      double leastPitch,
      double dtS) {
    double scale = scale(state);
    double limit = Math.min(bankLimit, stall.bankLimitRad(state));
    bankDemand = Limit.approach(bankDemand, Limit.symmetric(bank, limit), tuning.bankRate() * dtS);
    double slowest = stall.leastSpeedMps(bankDemand) + 0.5 * tuning.stall().bandMps();
    speedDemandMps = Limit.within(slowest, speedDemandMps, tuning.fastestMps());
    double most = Math.min(tuning.mostPitchRad(), stall.pitchLimitRad(state));
    EnergyLaw.Command command =
        energy.step(
            state,
            new EnergyLaw.Demand(
                altitudeDemandM,
                speedDemandMps * state.trueOverCalibrated(),
                speedOnly,
                Math.min(leastPitch, most),
                most),
            stall.urgency(state),
            dtS);
    throttle = command.throttle();
    double load = 1.0 / Math.max(0.5, StrictMath.cos(state.rollRad()));
    pitchDemand = Math.min(most, command.pitchRad() + tuning.turnPitch() * (load - 1.0));
    double aileron = roll.aileron(state, bankDemand, scale, dtS);
    double elevator = pitch.elevator(state, pitchDemand, scale, dtS);
    rudder = Limit.approach(rudder, yaw.rudder(state, aileron, scale, dtS), RUDDER_RATE * dtS);
    return new Surfaces(aileron, elevator, rudder, throttle, 1.0, 0.0, 0.0);
  }

  /** Follows navigation sideways only, and lets the aircraft down on its wheels. */
  private Surfaces touchDown(FlightState state, Optional<GuidanceTarget> target, double dtS) {
    double scale = scale(state);
    double bank =
        target.map(ahead -> lateral.bankRad(state, ahead.northM(), ahead.eastM())).orElse(0.0);
    double wanted = state.onGround() ? 0.0 : Limit.symmetric(bank, FLARE_BANK_RAD);
    bankDemand = Limit.approach(bankDemand, wanted, tuning.bankRate() * dtS);
    throttle = Limit.approach(throttle, 0.0, tuning.climbOut().throttleRate() * dtS);
    pitchDemand = flare.pitchRad(state, dtS);
    double aileron = roll.aileron(state, bankDemand, scale, dtS);
    double elevator = pitch.elevator(state, pitchDemand, scale, dtS);
    if (state.onGround()) {
      rudder = ground.rudder(state, true, dtS);
    } else {
      ground.lineUpAlongTrack(state);
      rudder = Limit.approach(rudder, yaw.rudder(state, aileron, scale, dtS), RUDDER_RATE * dtS);
    }
    return new Surfaces(aileron, elevator, rudder, throttle, 1.0, 0.0, 0.0);
  }

  private Surfaces stop(FlightState state, double dtS) {
    throttle = 0.0;
    Surfaces parked = Surfaces.parked();
    boolean rolls = ground.lined() && state.groundSpeedMps() > ROLLING_MPS;
    rudder = rolls ? ground.rudder(state, true, dtS) : 0.0;
    return new Surfaces(0.0, 0.0, rudder, 0.0, parked.mixture(), 0.0, parked.brakes());
  }

  private double scale(FlightState state) {
    double speed = Math.max(1.0, state.calibratedAirspeedMps());
    return Limit.within(LEAST_SCALE, tuning.referenceSpeedMps() / speed, MOST_SCALE);
  }

  FlightPhase phase() {
    return phase;
  }

  /** Bank demanded [rad]. */
  double bankDemandRad() {
    return bankDemand;
  }

  /** Pitch demanded [rad]. */
  double pitchDemandRad() {
    return pitchDemand;
  }

  /** Altitude demanded, above mean sea level [m]. */
  double altitudeDemandM() {
    return altitudeDemandM;
  }

  /** Calibrated airspeed demanded [m/s]. */
  double speedDemandMps() {
    return speedDemandMps;
  }
}
