package org.u2sa.control.fixedwing;

import java.util.Optional;
import org.u2sa.control.Transfer;

/** The airborne phases: climb-out, cruise, holding and go-around. */
final class AirbornePhases {
  private static final double NEAR_GROUND_M = 10.0;
  private static final double HEIGHT_FIRST_BELOW = 0.5; // fraction of the safe height
  private static final double LEADS_UP_M = 10.0; // navigation, as when it goes round
  private static final double LEVEL_WINGS_MPS = 3.0; // excess sink rate at which it does not bank

  private final AutopilotVariables tuning;
  private final GuidanceVariables guidance;
  private final GroundSteering steering;
  private final InnerLoops loops;
  private final LateralGuidance lateral;
  private final EnergyLaw energy;
  private final LaunchClimb launch = new LaunchClimb();
  private final WindEstimate wind;

  private double holdAltitudeM;
  private double altitudeDemandM;
  private double speedDemandMps; // calibrated
  private double raisedToMps; // against the wind; 0 if not raised

  AirbornePhases(
      AutopilotVariables tuning, GroundSteering steering, InnerLoops loops, WindEstimate wind) {
    this.tuning = tuning;
    guidance = tuning.guidance();
    this.steering = steering;
    this.loops = loops;
    this.wind = wind;
    lateral = new LateralGuidance(guidance.minLookAhead());
    energy = new EnergyLaw(tuning.energy());
    speedDemandMps = guidance.cruiseSpeed();
  }

  /** Sets the altitude to hold without navigation: the current one, or a safe one above it. */
  void holdHere(FlightState state) {
    holdAltitudeM = Math.max(state.altitudeM(), safeAltitudeM(state));
  }

  private double safeAltitudeM(FlightState state) {
    return state.altitudeM() - state.heightM() + tuning.takeOff().safeHeight();
  }

  /** Restarts the energy law at a pitch, with the current throttle. */
  void restartEnergy(FlightState state, double pitchRad) {
    energy.restart(state, pitchRad, loops.throttle());
  }

  /** Arrests the climb or descent in which the aeroplane was taken over. */
  void arrest() {
    energy.arrest();
  }

  Surfaces climbOut(FlightState state, double dtS) {
    AutopilotVariables.ClimbOut climb = tuning.climbOut();
    double look = climb.climbOutLookAhead();
    double bank =
        lateral.bankRad(state, steering.aheadNorthM(state, look), steering.aheadEastM(state, look));
    altitudeDemandM = safeAltitudeM(state);
    speedDemandMps = AutopilotVariables.KNOT_MPS * climb.climbOutSpeed();
    // Near the ground the nose keeps its take-off pitch, whatever the airspeed demands.
    double low = Limit.within(0.0, 2.0 - state.heightM() / NEAR_GROUND_M, 1.0);
    double lower = Math.toRadians(climb.climbOutPitchLowerLimit());
    double least = lower + low * Math.max(0.0, tuning.rotationPitchRad(wind) - lower);
    return surfaces(
        state,
        bank,
        Math.toRadians(climb.climbOutBankLimit()),
        EnergyLaw.Priority.SPEED,
        least,
        dtS);
  }

  /**
   * @param circles whether to circle without navigation
   */
  Surfaces fly(FlightState state, Optional<GuidanceTarget> target, boolean circles, double dtS) {
    raisedToMps = 0.0;
    double bank = circles ? Math.toRadians(tuning.hold().holdBank()) : 0.0;
    altitudeDemandM = holdAltitudeM;
    speedDemandMps = guidance.cruiseSpeed();
    if (target.isPresent()) {
      GuidanceTarget ahead = target.get();
      bank = lateral.bankRad(state, ahead.northM(), ahead.eastM(), wind);
      altitudeDemandM = ahead.altitudeM();
      speedDemandMps =
          ahead.speedMps().orElse(speedDemandMps * state.trueOverCalibrated())
              / state.trueOverCalibrated();
      speedDemandMps = againstWindMps(state, ahead, speedDemandMps);
      holdAltitudeM = altitudeDemandM;
    }
    boolean leadsUpLow =
        altitudeDemandM > state.altitudeM() + LEADS_UP_M
            && state.heightM() < HEIGHT_FIRST_BELOW * tuning.takeOff().safeHeight();
    if (leadsUpLow) {
      energy.levelOff();
    }
    launch.see(state, guidance.leastSpeedMps(0.0), altitudeDemandM);
    if (launch.isUnderWay()) {
      energy.levelOff();
      altitudeDemandM = Math.max(altitudeDemandM, launch.topM());
      if (target.isEmpty()) {
        holdAltitudeM = altitudeDemandM;
      }
    }
    return surfaces(
        state,
        bank,
        launch.bankLimitRad(Math.toRadians(guidance.bankLimit())),
        leadsUpLow || launch.isUnderWay() ? EnergyLaw.Priority.HEIGHT : EnergyLaw.Priority.BOTH,
        Math.toRadians(guidance.pitchLowerLimit()),
        dtS);
  }

  /**
   * Climbs to the safe height and follows navigation laterally there. Near the ground, bank is
   * limited regardless of navigation, and the speed is above approach speed, because landings are
   * refused in strong wind with gusts. Near the ground, height takes priority over speed.
   */
  Surfaces goAround(FlightState state, GuidanceTarget target, double dtS) {
    altitudeDemandM = Math.max(target.altitudeM(), safeAltitudeM(state));
    holdAltitudeM = altitudeDemandM;
    double calibratedMps = target.speedMps().orElse(0.0) / state.trueOverCalibrated();
    speedDemandMps =
        Math.max(calibratedMps, guidance.cruiseSpeed()) + guidance.gustShare() * wind.speedMps();
    speedDemandMps = againstWindMps(state, target, speedDemandMps);
    if (state.climbMps() < 0.0) {
      energy.levelOff();
    }
    double share = Limit.within(0.0, state.heightM() / tuning.takeOff().safeHeight(), 1.0);
    return surfaces(
        state,
        lateral.bankRad(state, target.northM(), target.eastM(), wind),
        share * share * Math.toRadians(guidance.bankLimit()),
        share < HEIGHT_FIRST_BELOW ? EnergyLaw.Priority.HEIGHT : EnergyLaw.Priority.BOTH,
        Math.toRadians(guidance.pitchLowerLimit()),
        dtS);
  }

  /**
   * Calibrated airspeed with which it still advances towards navigation [m/s].
   *
   * @param usualMps the one without a wind that is nearly as fast
   */
  private double againstWindMps(FlightState state, GuidanceTarget ahead, double usualMps) {
    double course = StrictMath.atan2(ahead.eastM(), ahead.northM());
    double leastMps = guidance.minGroundSpeed();
    double neededMps =
        leastMps > 0.0 ? wind.airspeedMps(course, leastMps) / state.trueOverCalibrated() : 0.0;
    raisedToMps = neededMps > usualMps ? Math.min(neededMps, guidance.maxSpeed()) : 0.0;
    return Math.max(usualMps, raisedToMps);
  }

  private Surfaces surfaces(
      FlightState state,
      double bank,
      double bankLimit,
      EnergyLaw.Priority priority,
      double leastPitch,
      double dtS) {
    double excess = energy.excessClimbMps(state, altitudeDemandM);
    double share = Limit.within(0.0, 1.0 + excess / LEVEL_WINGS_MPS, 1.0);
    double limit = share * Math.min(bankLimit, guidance.bankLimitRad(state));
    loops.bankTowards(Limit.symmetric(bank, limit), dtS);
    double slowest =
        guidance.leastSpeedMps(loops.bankRad())
            + 0.5 * guidance.stallBand()
            + guidance.gustShare() * wind.speedMps();
    double fastest = guidance.maxSpeed();
    speedDemandMps = Limit.within(Math.min(slowest, fastest), speedDemandMps, fastest);
    double most =
        Math.min(Math.toRadians(guidance.pitchUpperLimit()), guidance.pitchLimitRad(state));
    EnergyLaw.Command command =
        energy.step(
            state,
            new EnergyLaw.Demand(
                altitudeDemandM,
                speedDemandMps * state.trueOverCalibrated(),
                priority,
                Math.min(leastPitch, most),
                most,
                guidance.pullUpMps2(state)),
            guidance.urgency(state),
            dtS);
    loops.throttle(command.throttle());
    double load = 1.0 / Math.max(0.5, StrictMath.cos(state.rollRad()));
    loops.pitch(
        Math.min(most, command.pitchRad() + Math.toRadians(guidance.turnPitch()) * (load - 1.0)));
    double aileron = loops.aileron(state, dtS);
    double elevator = loops.elevator(state, dtS);
    loops.coordinate(state, aileron, dtS);
    return new Surfaces(aileron, elevator, loops.rudder(), loops.throttle(), 1.0, 0.0, 0.0);
  }

  /** Altitude demanded, above mean sea level [m]. */
  double altitudeDemandM() {
    return altitudeDemandM;
  }

  /** Calibrated airspeed demanded [m/s]. */
  double speedDemandMps() {
    return speedDemandMps;
  }

  /** Sink rate demanded at the last step [m/s]; negative for a climb. */
  double wantedSinkMps() {
    return -energy.climbDemandMps();
  }

  /** Calibrated airspeed to which the wind has raised the demand [m/s]; 0 if it has not. */
  double raisedToMps() {
    return raisedToMps;
  }

  void transfer(Transfer state) {
    holdAltitudeM = state.number("HOLD ALTITUDE", holdAltitudeM);
    altitudeDemandM = state.number("ALTITUDE DEMAND", altitudeDemandM);
    speedDemandMps = state.number("SPEED DEMAND", speedDemandMps, guidance.cruiseSpeed());
    energy.transfer(state);
    launch.transfer(state);
  }

  /**
   * First climb of an aeroplane that is launched by hand or catapult: until it is clear of the
   * ground, height comes before speed, and bank is limited. It ends 20 m above the launcher, or at
   * a demanded altitude that is lower; before it descends below the launcher, such as from a hill,
   * it climbs all the same. Its launcher is where it was last seen at rest; one first seen in
   * flight is clear.
   */
  static final class LaunchClimb {
    private static final double AT_REST_MPS = 2.0; // over ground
    private static final double CLEAR_M = 20.0; // above the launcher
    private static final double LOW_M = 5.0; // minimum height of a demanded altitude to end at
    private static final double NEAR_M = 1.0; // from a demand, which is approached slowly
    private static final double TOP_M = 25.0; // likewise
    private static final double BANK_AT_LAUNCHER_RAD = Math.toRadians(5.0);

    private double launcherM; // altitude
    private double leastM; // altitude to demand at least
    private double share = 1.0; // of the climb

    /**
     * @param stallMps calibrated airspeed below which it does not fly
     * @param demandM demanded altitude
     */
    void see(FlightState state, double stallMps, double demandM) {
      boolean atRest =
          state.groundSpeedMps() < AT_REST_MPS && state.calibratedAirspeedMps() < stallMps;
      if (atRest) {
        launcherM = state.altitudeM();
      }
      if (atRest || isUnderWay()) {
        double aboveM = demandM - launcherM;
        leastM = launcherM + (aboveM < LOW_M ? TOP_M : 0.0);
        boolean isThere = aboveM >= LOW_M && state.altitudeM() > demandM - NEAR_M;
        double climbed = (state.altitudeM() - launcherM) / CLEAR_M;
        share = isThere ? 1.0 : Limit.within(0.0, climbed, 1.0);
      }
    }

    /** Whether the aeroplane waits on its launcher or is not clear of the ground yet. */
    boolean isUnderWay() {
      return share < 1.0;
    }

    /** Minimum altitude to demand until it is clear [m]. */
    double topM() {
      return leastM;
    }

    /**
     * Bank limit [rad], which rises with the height above the launcher.
     *
     * @param usualRad limit in flight
     */
    double bankLimitRad(double usualRad) {
      double least = Math.min(usualRad, BANK_AT_LAUNCHER_RAD);
      return least + share * (usualRad - least);
    }

    void transfer(Transfer state) {
      launcherM = state.number("LAUNCHER ALTITUDE", launcherM);
      share = state.number("SHARE OF LAUNCH CLIMB", share, 1.0);
    }
  }
}
