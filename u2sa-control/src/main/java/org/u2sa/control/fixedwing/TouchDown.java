package org.u2sa.control.fixedwing;

import org.u2sa.control.Transfer;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;

/**
 * The last metres of a landing, and the roll-out. In the air it holds the runway's centreline by
 * bank, reduces sink rate and power, and near the ground aligns the nose with the runway, windward
 * wing low. On its wheels it holds the wings level by aileron, turned into the wind as speed falls,
 * lowers the nose, then pulls the elevator back, and brakes harder as speed falls (Cessna 172P
 * handbook, section 4: crosswind and short-field landing; FAA Airplane Flying Handbook, chapter 9).
 */
final class TouchDown {
  /** Variables of the last metres, and the crosswind limit. */
  record Variables(
      @Variable(unit = "m", min = 0, max = 10, ifAbsent = 1.5)
          @Description("Height above ground at which the nose is aligned with the runway.")
          double alignHeight,
      @Variable(unit = "deg", min = 0, max = 12, ifAbsent = 8)
          @Description("Maximum bank in the flare.")
          double flareBankLimit,
      @Variable(unit = "m", min = 20, max = 500, ifAbsent = 120)
          @Description("Distance to the aim point on the runway centreline in the flare.")
          double flareLookAhead,
      @Variable(unit = "1/rad", min = 0, max = 5, ifAbsent = 1.6)
          @Description(
              "Aileron per sideslip that holds the wings level: dihedral effect over aileron effect.")
          double aileronPerSideslip,
      @Variable(unit = "m/s", min = 10, max = 40, ifAbsent = 28)
          @Description(
              "Ground speed above which the brakes are hardly used; below it they are applied gradually.")
          double brakeSpeed,
      @Variable(unit = "m/s", min = 0, max = 20, ifAbsent = 13)
          @Description(
              "Maximum crosswind for landing, as measured by the aircraft; above it the aircraft stays at SAFE HEIGHT.")
          double maxCrosswind) {}

  private static final double LEVEL_MPS = 10.0; // below this, ailerons cannot level the wings
  private static final double LIGHT_BRAKES = 0.15;
  private static final double FULL_BRAKES_MPS = 8.0;
  private static final double NOSE_UP_RAD = Math.toRadians(4.5);
  private static final double ROLLING_MPS = 2.0;
  private static final double ELEVATOR_BACK = -0.6; // full travel could strike the tail
  private static final double ELEVATOR_BACK_FAST = -0.1; // takes load off the nose wheel
  private static final double NO_LIFT_MPS = 22.0; // below this airspeed it does not lift off
  private static final double THROTTLE_PER_SINK = 0.25; // [s/m]
  private static final double SPARE_SINK_MPS = 0.8; // excess sink rate without power
  private static final double MAX_THROTTLE = 0.6;

  private final Variables parameters;
  private final GroundSteering steering;
  private final InnerLoops loops;
  private final FlareLaw flare;
  private final LateralGuidance lateral;
  private boolean nosewheel; // whether it is down and steers

  TouchDown(
      Variables parameters, FlareLaw.Variables flare, GroundSteering steering, InnerLoops loops) {
    this.parameters = parameters;
    this.steering = steering;
    this.loops = loops;
    this.flare = new FlareLaw(flare);
    lateral = new LateralGuidance(parameters.flareLookAhead());
  }

  /** Height above ground at which the flare starts [m]. */
  double heightM() {
    return flare.heightM();
  }

  /** Sink rate demanded in the flare [m/s]. */
  double wantedSinkMps(FlightState state) {
    return flare.wantedSinkMps(state);
  }

  /** Starts the flare: the centreline is the line of navigation, or else the ground track. */
  void begin(FlightState state, FinalApproach approach) {
    flare.restart(loops.pitchRad());
    nosewheel = false;
    if (approach.isKnown()) {
      steering.lineUpAlong(approach.northM(), approach.eastM(), approach.courseRad());
    } else {
      steering.lineUpAlongTrack(state);
    }
  }

  /** Flares until the wheels have carried load for a while. */
  Surfaces flare(FlightState state, double dtS) {
    double look = parameters.flareLookAhead();
    double bank =
        lateral.bankRad(state, steering.aheadNorthM(state, look), steering.aheadEastM(state, look));
    boolean wheels = state.onGround();
    double excess = flare.excessSinkMps(state);
    double power =
        wheels
            ? 0.0
            : Limit.within(0.0, THROTTLE_PER_SINK * (excess - SPARE_SINK_MPS), MAX_THROTTLE);
    loops.throttleTowards(power, dtS);
    loops.pitch(flare.pitchRad(state, dtS));
    double elevator = loops.elevator(state, dtS);
    if (wheels) {
      return new Surfaces(
          ailerons(state, dtS), elevator, steer(state, dtS), loops.throttle(), 1.0, 0.0, 0.0);
    }
    loops.bankTowards(Limit.symmetric(bank, Math.toRadians(parameters.flareBankLimit())), dtS);
    double aileron = loops.aileron(state, dtS);
    if (state.heightM() < parameters.alignHeight()) {
      aileron = Limit.symmetric(aileron + intoWind(state), 1.0);
      loops.rudder(steering.align(state, dtS));
    } else {
      loops.coordinate(state, aileron, dtS);
      steering.holds(loops.rudder());
    }
    return new Surfaces(aileron, elevator, loops.rudder(), loops.throttle(), 1.0, 0.0, 0.0);
  }

  /** Rolls out on the wheels, to a stop on the brakes. */
  Surfaces rollOut(FlightState state, double dtS) {
    loops.throttle(0.0);
    double speed = state.groundSpeedMps();
    if (!steering.lined() || speed < ROLLING_MPS) {
      loops.rudder(0.0);
      return new Surfaces(intoWind(state), 0.0, 0.0, 0.0, 1.0, 0.0, 1.0);
    }
    double slow = Limit.within(0.0, 1.0 - state.calibratedAirspeedMps() / NO_LIFT_MPS, 1.0);
    double elevator = ELEVATOR_BACK_FAST + ELEVATOR_BACK * slow;
    if (isNoseUp(state)) {
      loops.pitch(flare.pitchRad(state, dtS));
      elevator = loops.elevator(state, dtS);
    }
    double share =
        Limit.within(
            0.0,
            (parameters.brakeSpeed() - speed) / (parameters.brakeSpeed() - FULL_BRAKES_MPS),
            1.0);
    double brakes = state.onGround() ? LIGHT_BRAKES + (1.0 - LIGHT_BRAKES) * share : 0.0;
    return new Surfaces(ailerons(state, dtS), elevator, steer(state, dtS), 0.0, 1.0, 0.0, brakes);
  }

  /** Aileron into the wind; holds the wings level while the ailerons are effective. */
  private double ailerons(FlightState state, double dtS) {
    double level = state.calibratedAirspeedMps() > LEVEL_MPS ? loops.levelAileron(state, dtS) : 0.0;
    loops.hold(0.0);
    return Limit.symmetric(intoWind(state) + level, 1.0);
  }

  /** Aileron that keeps the wind from lifting the upwind wing: full for wind abeam. */
  private double intoWind(FlightState state) {
    return Limit.symmetric(parameters.aileronPerSideslip() * StrictMath.sin(state.betaRad()), 1.0);
  }

  private double steer(FlightState state, double dtS) {
    boolean steers = !isNoseUp(state);
    if (steers && !nosewheel) {
      steering.holds(0.0); // the crab rudder would steer off the runway
    }
    nosewheel = steers;
    loops.rudder(steering.gentleRudder(state, steers, dtS));
    return loops.rudder();
  }

  private static boolean isNoseUp(FlightState state) {
    return state.pitchRad() > NOSE_UP_RAD;
  }

  void transfer(Transfer state) {
    flare.transfer(state);
    nosewheel = state.flag("NOSEWHEEL STEERS", nosewheel);
  }

  /**
   * Recognises the ground by a descent that is not followed, for aircraft without sensors of weight
   * on wheels, whose altitude may be wrong; gusts hold it up less steadily. In an approach this
   * begins the flare, in which power is off and an aircraft in the air sinks; if it does not sink
   * there either, it is on its wheels.
   */
  static final class ContactWatch {
    private static final double NEAR_M = 15.0; // height as known, also above which no flare goes on
    private static final double SINKS_MPS = 0.5; // least demanded sink rate that tells
    private static final double FOLLOWED_SHARE = 0.3; // also if the known velocity errs
    private static final double NOISE_M = 0.25;
    private static final double STEADY_MPS = 0.3; // gusts change a climb rate by more
    private static final double SMOOTHED_S = 0.3;
    private static final double SURE_S = 2.0;

    private double wantedM; // descent
    private double sunkM;
    private double forS;
    private double climbMps; // smoothed; the least and the most in that time
    private double leastMps;
    private double mostMps;
    private boolean hindered;
    private boolean grounded;

    /** Restarts, as at the beginning of a flare. */
    void begin() {
      wantedM = 0.0;
      sunkM = 0.0;
      forS = 0.0;
      leastMps = climbMps;
      mostMps = climbMps;
      hindered = false;
    }

    /**
     * @param wantedSinkMps demanded sink rate of a landing; 0 without one
     */
    void step(FlightState state, FlightPhase phase, double wantedSinkMps, double dtS) {
      boolean isFlare = phase == FlightPhase.FLARE;
      climbMps += dtS / (SMOOTHED_S + dtS) * (state.climbMps() - climbMps);
      if (phase == FlightPhase.STOPPED) {
        return;
      }
      grounded &= isFlare;
      if (wantedSinkMps < SINKS_MPS || state.wheelsSensed() || state.heightM() > NEAR_M) {
        begin();
        return;
      }
      wantedM += wantedSinkMps * dtS;
      sunkM -= state.climbMps() * dtS;
      forS += dtS;
      leastMps = Math.min(leastMps, climbMps);
      mostMps = Math.max(mostMps, climbMps);
      boolean isFollowed = sunkM > FOLLOWED_SHARE * wantedM + NOISE_M;
      if (isFollowed || mostMps - leastMps > STEADY_MPS || climbMps > STEADY_MPS) {
        begin();
      }
      hindered = forS >= SURE_S;
      grounded |= isFlare && hindered;
    }

    /** Whether the descent is not followed. */
    boolean isHindered() {
      return hindered;
    }

    /** Whether the wheels carry the aircraft, in the flare and until it takes off again. */
    boolean isOnGround() {
      return grounded;
    }

    void transfer(Transfer state) {
      wantedM = state.number("WANTED DESCENT", wantedM);
      sunkM = state.number("DESCENT", sunkM);
      forS = state.number("DESCENT LASTS", forS);
      climbMps = state.number("SMOOTHED CLIMB", climbMps);
      leastMps = state.number("LEAST CLIMB", leastMps);
      mostMps = state.number("MOST CLIMB", mostMps);
      hindered = state.flag("DESCENT HINDERED", hindered);
      grounded = state.flag("FOUND ON GROUND", grounded);
    }
  }
}
