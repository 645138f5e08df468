package org.u2sa.control.fixedwing;

import java.util.ArrayDeque;
import java.util.Optional;
import org.u2sa.sim.aircraft.AircraftMotion;
import org.u2sa.sim.aircraft.Cessna172;
import org.u2sa.sim.aircraft.ControlInputs;
import org.u2sa.sim.aircraft.RunwayStart;
import org.u2sa.sim.atmosphere.Wind;

/** One flight of the autopilot against the simulated Cessna, scored against truth. */
final class SimulatedFlight {
  private static final double LONGEST_S = 2400.0;
  private static final double FROM_LONGITUDE = -157.943183;
  private static final double FROM_LATITUDE = 21.325247;

  /**
   * How the loop is closed.
   *
   * @param rateHz of the controller
   * @param delayS between measurement and surface beyond the rate's own [s]
   * @param effect of the surfaces: 1 as simulated
   */
  record Loop(double rateHz, double delayS, double effect) {
    static Loop lockstep() {
      return new Loop(50.0, 0.0, 1.0);
    }

    static Loop flightGear() {
      return new Loop(20.0, 0.1, 1.0);
    }
  }

  private final Course course;
  private final Loop loop;
  private final double elevationM;
  private final Cessna172 aircraft;
  private final Autopilot autopilot;
  private final LegFollower planner;
  private final ArrayDeque<ControlInputs> underWay = new ArrayDeque<>();
  private final FlightScore score;
  StringBuilder trace;
  SurfaceMixing left = SurfaceMixing.SOUND; // of the surfaces, from failsAtS on
  double failsAtS = Double.POSITIVE_INFINITY;
  boolean knows = true; // the control hears of it

  SimulatedFlight(
      AutopilotVariables tuning, Course course, Wind wind, Loop loop, double elevationM) {
    this.course = course;
    this.loop = loop;
    this.elevationM = elevationM;
    this.aircraft =
        Cessna172.onRunway(
            new RunwayStart(FROM_LONGITUDE, FROM_LATITUDE, elevationM, Math.PI / 2.0), wind, true);
    this.autopilot = new Autopilot(tuning);
    this.planner = new LegFollower(course);
    this.score = new FlightScore(course);
  }

  FlightScore fly() {
    return fly(LONGEST_S);
  }

  /** Flies for that long at most [s]. */
  FlightScore fly(double longestS) {
    int late = (int) Math.round(loop.delayS() * loop.rateHz());
    ControlInputs now = inputs(new Surfaces(0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0));
    for (int i = 0; i < late; i++) {
      underWay.add(now);
    }
    while (!planner.finished() && aircraft.state().timeS() < longestS) {
      AircraftMotion truth = aircraft.state();
      FlightState state = see(truth, FROM_LONGITUDE, FROM_LATITUDE);
      Optional<GuidanceTarget> target = Optional.of(planner.follow(state));
      Surfaces surfaces = autopilot.step(state, target);
      if (planner.finished()) {
        break;
      }
      boolean failed = truth.timeS() >= failsAtS;
      if (failed) {
        surfaces = broken(knows ? left.of(surfaces) : surfaces);
      }
      score.note(truth, state, autopilot, planner, surfaces);
      if (trace != null) {
        trace.append(
            String.format(
                java.util.Locale.ROOT,
                "%.2f,%s,%d,%.1f,%.1f,%.1f,%.2f,%.2f,%.2f,%.2f,%.2f,%.2f,%.2f,%.1f,%.3f,%.3f,%.3f,%.3f,%.2f,%.1f,%.0f%n",
                state.timeS(),
                autopilot.phase(),
                planner.leg(),
                state.northM(),
                state.eastM(),
                state.altitudeM(),
                state.heightM(),
                Math.toDegrees(state.rollRad()),
                Math.toDegrees(autopilot.bankDemandRad()),
                Math.toDegrees(state.pitchRad()),
                Math.toDegrees(autopilot.pitchDemandRad()),
                state.calibratedAirspeedMps(),
                autopilot.speedDemandMps(),
                autopilot.altitudeDemandM(),
                surfaces.aileron(),
                surfaces.elevator(),
                surfaces.rudder(),
                surfaces.throttle(),
                Math.toDegrees(state.betaRad()),
                planner.offsetM(state),
                state.engineRpm()));
      }
      underWay.add(inputs(surfaces));
      aircraft.step(underWay.remove(), 1.0 / loop.rateHz());
      if (truth.crashed()) {
        break;
      }
    }
    return score;
  }

  /** What the surfaces that are left do of what was commanded. */
  private Surfaces broken(Surfaces s) {
    return new Surfaces(
        left.aileron() * s.aileron(),
        left.elevator() * s.elevator(),
        left.rudder() * s.rudder(),
        s.throttle(),
        s.mixture(),
        s.flaps(),
        s.brakes());
  }

  private ControlInputs inputs(Surfaces s) {
    return ControlInputs.limited(
        s.aileron() * loop.effect(),
        s.elevator() * loop.effect(),
        s.rudder() * loop.effect(),
        s.throttle(),
        s.mixture(),
        s.flaps(),
        s.brakes(),
        s.brakes());
  }

  /** Truth as the autopilot sees it, from a place that is north 0, east 0. */
  static FlightState see(AircraftMotion s, double longitudeDeg, double latitudeDeg) {
    double sin = Math.sin(Math.toRadians(latitudeDeg));
    double w2 = 1.0 - 6.69437999014e-3 * sin * sin;
    double prime = 6_378_137.0 / Math.sqrt(w2);
    double meridian = prime * (1.0 - 6.69437999014e-3) / w2;
    return new FlightState(
        s.timeS(),
        Math.toRadians(s.latitudeDeg() - latitudeDeg) * meridian,
        Math.toRadians(s.longitudeDeg() - longitudeDeg)
            * prime
            * Math.cos(Math.toRadians(latitudeDeg)),
        s.altitudeM(),
        s.heightAboveGroundM(),
        s.rollRad(),
        s.pitchRad(),
        s.headingRad(),
        s.rollRateRadPerS(),
        s.pitchRateRadPerS(),
        s.yawRateRadPerS(),
        s.velocityNorthMps(),
        s.velocityEastMps(),
        -s.velocityDownMps(),
        s.trueAirspeedMps(),
        s.calibratedAirspeedMps(),
        s.angleOfAttackRad(),
        s.sideslipRad(),
        s.weightOnWheels(),
        s.engineRpm(),
        false,
        true,
        true);
  }
}
