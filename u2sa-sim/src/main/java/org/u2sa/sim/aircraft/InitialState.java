package org.u2sa.sim.aircraft;

import static org.u2sa.sim.aircraft.FlightDynamics.ALT;
import static org.u2sa.sim.aircraft.FlightDynamics.LAT;
import static org.u2sa.sim.aircraft.FlightDynamics.LON;
import static org.u2sa.sim.aircraft.FlightDynamics.Q0;
import static org.u2sa.sim.aircraft.FlightDynamics.SHAFT;
import static org.u2sa.sim.aircraft.FlightDynamics.VD;
import static org.u2sa.sim.aircraft.FlightDynamics.VE;
import static org.u2sa.sim.aircraft.FlightDynamics.VN;

import org.u2sa.sim.atmosphere.Wind;
import org.u2sa.sim.atmosphere.WindField;
import org.u2sa.sim.motion.BodyAttitude;

/** Initial state vectors of {@link FlightDynamics}. */
final class InitialState {
  private InitialState() {}

  /** At rest on the wheels, with the legs compressed by the static load. */
  static double[] standing(RunwayStart start, boolean engineRunning) {
    double[] s = at(start.longitudeDeg(), start.latitudeDeg());
    s[ALT] = start.elevationM() + LandingGear.STANDING_M;
    BodyAttitude.write(s, Q0, 0.0, LandingGear.STANDING_PITCH_RAD, start.headingRad());
    s[SHAFT] = engineRunning ? PistonEngine.IDLE_RPM * PistonEngine.RADPERS_PER_RPM : 0.0;
    return s;
  }

  /** Airborne, with the requested airspeed relative to the steady wind. */
  static double[] flying(FlightStart start, Wind wind) {
    double[] s = at(start.longitudeDeg(), start.latitudeDeg());
    s[ALT] = start.altitudeM();
    BodyAttitude.write(s, Q0, start.rollRad(), start.pitchRad(), start.headingRad());
    BodyAttitude attitude = new BodyAttitude();
    attitude.set(s[Q0], s[Q0 + 1], s[Q0 + 2], s[Q0 + 3]);
    double cosBeta = StrictMath.cos(start.sideslipRad());
    double u = start.trueAirspeedMps() * StrictMath.cos(start.angleOfAttackRad()) * cosBeta;
    double v = start.trueAirspeedMps() * StrictMath.sin(start.sideslipRad());
    double w = start.trueAirspeedMps() * StrictMath.sin(start.angleOfAttackRad()) * cosBeta;
    WindField steady = new WindField(wind.withGusts(0.0, 0L), Airframe.SPAN_M);
    steady.step(1.0, start.altitudeM() - start.groundElevationM(), 0.0, 1.0, 0.0);
    s[VN] = attitude.north(u, v, w) + steady.northMps();
    s[VE] = attitude.east(u, v, w) + steady.eastMps();
    s[VD] = attitude.down(u, v, w);
    s[SHAFT] = start.engineRpm() * PistonEngine.RADPERS_PER_RPM;
    return s;
  }

  private static double[] at(double longitudeDeg, double latitudeDeg) {
    double[] s = new double[FlightDynamics.SIZE];
    s[LON] = Math.toRadians(longitudeDeg);
    s[LAT] = Math.toRadians(latitudeDeg);
    return s;
  }
}
