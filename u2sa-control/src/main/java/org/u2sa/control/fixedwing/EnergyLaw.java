package org.u2sa.control.fixedwing;

import org.u2sa.control.Transfer;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.frame.Gravity;

/**
 * Controls altitude and airspeed together: the throttle sets the total energy rate γ + V̇/g, the
 * pitch its distribution, γ − V̇/g (A. A. Lambregts, Vertical Flight Path and Speed Control
 * Autopilot Design Using Total Energy Principles, AIAA 83-2239). When airspeed is low, pitch
 * controls airspeed alone.
 */
final class EnergyLaw {
  /**
   * Gains and limits. Energy rates are angles, γ + V̇/g, so that the aircraft's weight does not
   * appear.
   */
  record Variables(
      @Variable(unit = "s", min = 1, max = 30, ifAbsent = 4)
          @Description("Altitude-error time constant.")
          double altitudeTimeConstant,
      @Variable(unit = "s", min = 1, max = 30, ifAbsent = 6)
          @Description("Airspeed-error time constant.")
          double speedTimeConstant,
      @Variable(unit = "m/s", min = 0.5, max = 10, ifAbsent = 3.5)
          @Description("Maximum demanded climb rate.")
          double climbLimit,
      @Variable(unit = "m/s", min = 0.5, max = 10, ifAbsent = 4)
          @Description("Maximum demanded sink rate.")
          double sinkLimit,
      @Variable(unit = "m/s^2", min = 0.1, max = 5, ifAbsent = 0.8)
          @Description("Maximum rate of change of the demanded climb rate.")
          double verticalAccelerationLimit,
      @Variable(unit = "m/s^2", min = 0.1, max = 5, ifAbsent = 1)
          @Description("Maximum acceleration.")
          double accelerationLimit,
      @Variable(unit = "s", min = 0.05, max = 20, ifAbsent = 1)
          @Description("Time constant of the airspeed low-pass; longer is calmer in gusts.")
          double airspeedFilter,
      @Variable(min = 0, max = 1, ifAbsent = 0.6) @Description("Throttle in level cruise.")
          double throttleTrim,
      @Variable(unit = "1/rad", min = 0, max = 20, ifAbsent = 2.5)
          @Description("Throttle per energy rate.")
          double throttleForwardGain,
      @Variable(unit = "1/rad", min = 0, max = 20, ifAbsent = 0.7)
          @Description("Throttle per energy-rate error.")
          double throttleDamping,
      @Variable(unit = "1/rad/s", min = 0, max = 20, ifAbsent = 0.4)
          @Description("Throttle per integrated energy-rate error.")
          double throttleIntegralGain,
      @Variable(min = 0, max = 1, ifAbsent = 0) @Description("Minimum throttle in flight.")
          double throttleLowerLimit,
      @Variable(min = 0, max = 1, ifAbsent = 1) @Description("Maximum throttle in cruise.")
          double throttleUpperLimit,
      @Variable(unit = "1/s", min = 0.01, max = 5, ifAbsent = 0.3)
          @Description("Maximum throttle rate.")
          double throttleRateLimit,
      @Variable(unit = "rad", min = 0, max = 0.5, ifAbsent = 0.037)
          @Description(
              "Induced drag over weight in level flight; grows in turns with the square of the load factor.")
          double turnDrag,
      @Variable(min = 0, max = 5, ifAbsent = 0.8) @Description("Pitch per energy-balance error.")
          double energyBalanceGain,
      @Variable(unit = "1/s", min = 0, max = 5, ifAbsent = 0.3)
          @Description("Pitch per integrated energy-balance error.")
          double energyBalanceIntegralGain,
      @Variable(unit = "deg/s", min = 0.5, max = 20, ifAbsent = 3)
          @Description("Maximum rate of the demanded pitch.")
          double pitchDemandRateLimit,
      @Variable(unit = "m/s", min = 2, max = 40, ifAbsent = 20)
          @Description("Minimum airspeed for computing flight-path angles.")
          double minSpeed) {}

  /** The law's output: pitch [rad] and throttle, 0…1. */
  record Command(double pitchRad, double throttle) {}

  /**
   * Set points of the law.
   *
   * @param altitudeM altitude above mean sea level [m]
   * @param airspeedMps true airspeed [m/s]
   * @param priority what pitch controls
   * @param least minimum pitch [rad]
   * @param most maximum pitch [rad]
   * @param pullUpMps2 vertical acceleration with which a descent may be arrested [m/s²]
   */
  record Demand(
      double altitudeM,
      double airspeedMps,
      Priority priority,
      double least,
      double most,
      double pullUpMps2) {}

  /** Quantity controlled by pitch. */
  enum Priority {
    /** Airspeed alone, at full throttle: climb-out. */
    SPEED(2.0),
    /** Altitude and airspeed equally. */
    BOTH(1.0),
    /** Altitude only, at full throttle while the airspeed margin lasts: close to the ground. */
    HEIGHT(0.0);

    private final double speedShare; // out of 2, shared by altitude and airspeed

    Priority(double speedShare) {
      this.speedShare = speedShare;
    }
  }

  private static final double ARRESTED_MPS = 0.5; // excess that may be left
  private static final double PUSH_OVER_MPS2 = 4.0;
  private static final double NOSE_PER_PATH = 2.0; // rates: the path lags behind the nose

  private final Variables parameters;
  private boolean isArresting;
  private double filteredAirspeed = Double.NaN;
  private double climbDemand;
  private double pitchIntegral;
  private double throttleIntegral;
  private double throttle;
  private double pitch;

  EnergyLaw(Variables parameters) {
    this.parameters = parameters;
  }

  /** Starts bumplessly from a pitch and a throttle. */
  void restart(FlightState state, double newPitch, double newThrottle) {
    filteredAirspeed = state.trueAirspeedMps();
    climbDemand = state.climbMps();
    pitch = newPitch;
    throttle = newThrottle;
    pitchIntegral = newPitch - flightPath(state);
    throttleIntegral = newThrottle;
  }

  /**
   * Arrests the climb or descent that another pilot or law left, as far as it is faster than
   * allowed or leads away from the demanded altitude: pitch controls height alone, as fast as the
   * airspeed allows, and the throttle is that of the flight path to come.
   */
  void arrest() {
    isArresting = true;
  }

  /**
   * Climb rate to take out of the motion that is being arrested [m/s], negative in a descent; 0
   * once it is arrested.
   *
   * @param altitudeM demanded altitude above mean sea level [m]
   */
  double excessClimbMps(FlightState state, double altitudeM) {
    double excess = state.climbMps() - arrestedMps(state.climbMps(), climbTo(state, altitudeM));
    isArresting &= Math.abs(excess) > ARRESTED_MPS;
    return isArresting ? excess : 0.0;
  }

  /** Nearest climb rate to the present one that leads to the demanded altitude, or keeps one. */
  private static double arrestedMps(double presentMps, double wantedMps) {
    return Limit.within(Math.min(0.0, wantedMps), presentMps, Math.max(0.0, wantedMps));
  }

  private double climbTo(FlightState state, double altitudeM) {
    return Limit.within(
        -parameters.sinkLimit(),
        (altitudeM - state.altitudeM()) / parameters.altitudeTimeConstant(),
        parameters.climbLimit());
  }

  /** Ends a descent immediately instead of gradually. */
  void levelOff() {
    climbDemand = Math.max(0.0, climbDemand);
  }

  /** Climb rate demanded at the last step [m/s]. */
  double climbDemandMps() {
    return climbDemand;
  }

  void transfer(Transfer state) {
    isArresting = state.flag("ARRESTING", isArresting);
    filteredAirspeed = state.number("FILTERED AIRSPEED", filteredAirspeed, Double.NaN);
    climbDemand = state.number("CLIMB DEMAND", climbDemand);
    pitchIntegral = state.number("PITCH INTEGRAL OF ENERGY", pitchIntegral);
    throttleIntegral = state.number("THROTTLE INTEGRAL", throttleIntegral);
    throttle = state.number("THROTTLE OF ENERGY", throttle);
    pitch = state.number("PITCH OF ENERGY", pitch);
  }

  /**
   * @param urgency 0 with speed to spare … 1 at the minimum airspeed, by {@link
   *     GuidanceVariables#urgency}
   */
  Command step(FlightState state, Demand demand, double urgency, double dtS) {
    if (Double.isNaN(filteredAirspeed)) {
      restart(state, state.pitchRad(), parameters.throttleTrim());
    }
    double speed = Math.max(parameters.minSpeed(), state.trueAirspeedMps());
    double acceleration = acceleration(state, dtS);
    double path = flightPath(state);

    double excess = excessClimbMps(state, demand.altitudeM());
    double climb = climbTo(state, demand.altitudeM());
    boolean arrests = excess != 0.0;
    double bending = excess < 0.0 ? demand.pullUpMps2() : arrests ? PUSH_OVER_MPS2 : 0.0;
    double arrested = arrests ? arrestedMps(climbDemand, climb) : climbDemand;
    double usualChange = parameters.verticalAccelerationLimit() * dtS;
    climbDemand =
        arrested == climbDemand
            ? Limit.approach(climbDemand, climb, usualChange)
            : Limit.approach(climbDemand, arrested, Math.max(usualChange, bending * dtS));
    double pathDemand = climbDemand / speed;
    double pathToCome = arrests ? arrestedMps(climbDemand, climb) / speed : pathDemand;
    double accelerationDemand =
        Limit.symmetric(
                (demand.airspeedMps() - filteredAirspeed) / parameters.speedTimeConstant(),
                parameters.accelerationLimit())
            / Gravity.STANDARD_MPS2;

    double usual = arrests ? Priority.HEIGHT.speedShare : demand.priority().speedShare;
    double speedShare = usual + (2.0 - usual) * urgency;
    double heightShare = 2.0 - speedShare;
    throttle =
        throttle(
            state,
            pathToCome + accelerationDemand,
            path + acceleration,
            demand.priority() == Priority.BOTH ? urgency : 1.0,
            dtS);
    pitch =
        pitch(
            demand,
            heightShare * pathDemand - speedShare * accelerationDemand,
            heightShare * path - speedShare * acceleration,
            Math.max(
                    Math.toRadians(parameters.pitchDemandRateLimit()),
                    NOSE_PER_PATH * bending / speed)
                * dtS,
            dtS);
    return new Command(pitch, throttle);
  }

  private double throttle(
      FlightState state, double demanded, double measured, double urgency, double dtS) {
    double cosine = Math.max(0.3, StrictMath.cos(state.rollRad()));
    double turning = parameters.turnDrag() * (1.0 / (cosine * cosine) - 1.0);
    double error = demanded - measured;
    double direct =
        parameters.throttleForwardGain() * (demanded + turning)
            + parameters.throttleDamping() * error;
    double next = throttleIntegral + parameters.throttleIntegralGain() * error * dtS;
    double raw = direct + next;
    boolean deeper =
        (raw > parameters.throttleUpperLimit() && error > 0.0)
            || (raw < parameters.throttleLowerLimit() && error < 0.0);
    if (!deeper && urgency < 1.0) {
      throttleIntegral = Limit.within(0.0, next, 1.0);
    }
    double wanted =
        Limit.within(
            parameters.throttleLowerLimit(),
            direct + throttleIntegral,
            parameters.throttleUpperLimit());
    double urgent = wanted + urgency * (parameters.throttleUpperLimit() - wanted);
    return Limit.approach(throttle, urgent, parameters.throttleRateLimit() * dtS);
  }

  private double pitch(Demand demand, double demanded, double measured, double step, double dtS) {
    // A change of flight path changes the balance by twice as much, whatever the shares.
    double error = 0.5 * (demanded - measured);
    double direct = 0.5 * demanded + parameters.energyBalanceGain() * error;
    double next = pitchIntegral + parameters.energyBalanceIntegralGain() * error * dtS;
    double raw = direct + next;
    boolean deeper = (raw > demand.most() && error > 0.0) || (raw < demand.least() && error < 0.0);
    if (!deeper) {
      pitchIntegral = Limit.within(demand.least() - 0.2, next, demand.most() + 0.2);
    }
    double wanted = Limit.within(demand.least(), direct + pitchIntegral, demand.most());
    return Limit.approach(pitch, wanted, step);
  }

  /** V̇/g of a low-passed airspeed: gusts are faster than the aircraft can respond. */
  private double acceleration(FlightState state, double dtS) {
    double difference = state.trueAirspeedMps() - filteredAirspeed;
    double share = dtS / (parameters.airspeedFilter() + dtS);
    double change = share * difference;
    filteredAirspeed += change;
    return change / dtS / Gravity.STANDARD_MPS2;
  }

  private double flightPath(FlightState state) {
    return state.climbMps() / Math.max(parameters.minSpeed(), state.trueAirspeedMps());
  }
}
