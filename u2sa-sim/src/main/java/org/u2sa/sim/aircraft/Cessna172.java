package org.u2sa.sim.aircraft;

import static org.u2sa.sim.aircraft.FlightDynamics.ALT;
import static org.u2sa.sim.aircraft.FlightDynamics.LAT;
import static org.u2sa.sim.aircraft.FlightDynamics.LON;
import static org.u2sa.sim.aircraft.FlightDynamics.P;
import static org.u2sa.sim.aircraft.FlightDynamics.Q;
import static org.u2sa.sim.aircraft.FlightDynamics.Q0;
import static org.u2sa.sim.aircraft.FlightDynamics.R;
import static org.u2sa.sim.aircraft.FlightDynamics.SHAFT;
import static org.u2sa.sim.aircraft.FlightDynamics.TYRES;
import static org.u2sa.sim.aircraft.FlightDynamics.VD;
import static org.u2sa.sim.aircraft.FlightDynamics.VE;
import static org.u2sa.sim.aircraft.FlightDynamics.VN;

import java.util.Objects;
import org.u2sa.sim.atmosphere.Air;
import org.u2sa.sim.atmosphere.StandardAtmosphere;
import org.u2sa.sim.atmosphere.Wind;
import org.u2sa.sim.atmosphere.WindField;
import org.u2sa.sim.motion.RungeKutta;

/**
 * One simulated Cessna 172: controls in, state out. It steps at 120 Hz inside, whatever steps it is
 * asked for, and gives the same doubles for the same start, wind, seed and inputs on every machine.
 * Not safe for several threads.
 */
public final class Cessna172 {
  /** Rate of the physics inside [1/s]. */
  public static final int TICKS_PER_SECOND = 120;

  private static final double LONGEST_STEP_S = 60.0;
  private static final double FLAP_TRAVEL_S = 7.0; // for the whole 30°
  private static final double FLYING_MPS = 10.0; // slower air makes no stall
  private static final double STALL_MIDDLE = 0.5;
  private static final double HALTS_RAD_PER_S = 2.0; // a dead engine turning slower stands

  private final TerrainHeight terrain;
  private final WindField wind;
  private final FlightDynamics dynamics;
  private final RungeKutta integrator = new RungeKutta(FlightDynamics.SIZE);
  private final double[] rate = new double[FlightDynamics.SIZE];
  private final double[] s;
  private double flapPosition;
  private long ticks;
  private double dueS;
  private boolean crashed;

  private Cessna172(
      double[] start, TerrainHeight terrain, Wind wind, boolean engineRunning, double flaps) {
    this.s = start;
    this.terrain = Objects.requireNonNull(terrain, "terrain");
    this.wind = new WindField(Objects.requireNonNull(wind, "wind"), Airframe.SPAN_M);
    this.dynamics = new FlightDynamics(new PistonEngine(engineRunning));
    this.flapPosition = flaps;
    surround(1.0 / TICKS_PER_SECOND);
    prepare(ControlInputs.neutral());
    dynamics.derivatives(s, rate);
  }

  /** An aircraft standing on its wheels, on level ground of the start's elevation. */
  public static Cessna172 onRunway(RunwayStart start, Wind wind, boolean engineRunning) {
    return onRunway(start, TerrainHeight.plane(start.elevationM()), wind, engineRunning);
  }

  /** An aircraft standing on its wheels at the start's elevation, with other ground elsewhere. */
  public static Cessna172 onRunway(
      RunwayStart start, TerrainHeight terrain, Wind wind, boolean engineRunning) {
    double[] s = InitialState.standing(start, engineRunning);
    return new Cessna172(s, terrain, wind, engineRunning, 0.0);
  }

  /** An aircraft in the air; the airspeed is against the steady wind that blows there. */
  public static Cessna172 inFlight(FlightStart start, Wind wind) {
    return inFlight(start, TerrainHeight.plane(start.groundElevationM()), wind);
  }

  /** An aircraft in the air above other than level ground. */
  public static Cessna172 inFlight(FlightStart start, TerrainHeight terrain, Wind wind) {
    double[] s = InitialState.flying(start, wind);
    return new Cessna172(s, terrain, wind, start.engineRpm() > 0.0, start.flaps());
  }

  /**
   * Turns the starter until the engine idles; mixture cut-off stops it again. Does nothing to a
   * running or crashed one.
   */
  public void startEngine() {
    if (!crashed && !dynamics.engine.running()) {
      s[SHAFT] = PistonEngine.IDLE_RPM * PistonEngine.RADPERS_PER_RPM;
      dynamics.engine.start();
    }
  }

  /**
   * Moves on in time. What does not fill a tick of 1/120 s is kept for the next call, so that many
   * small steps equal one large step.
   *
   * @param inputs held during the step
   * @param dtS above 0, at most 60 s
   * @throws IllegalArgumentException if dt is outside its range
   */
  public void step(ControlInputs inputs, double dtS) {
    Objects.requireNonNull(inputs, "inputs");
    if (!(dtS > 0.0 && dtS <= LONGEST_STEP_S)) {
      throw new IllegalArgumentException("dt: " + dtS + " s is outside 0…" + LONGEST_STEP_S + " s");
    }
    dueS += dtS;
    long count = (long) StrictMath.floor(dueS * TICKS_PER_SECOND + 1e-6);
    dueS -= (double) count / TICKS_PER_SECOND;
    for (long i = 0; i < count; i++) {
      tick(inputs);
    }
  }

  private void tick(ControlInputs inputs) {
    ticks++;
    if (crashed) {
      return;
    }
    double dtS = 1.0 / TICKS_PER_SECOND;
    double flapStep = dtS / FLAP_TRAVEL_S;
    flapPosition += Math.max(-flapStep, Math.min(flapStep, inputs.flaps() - flapPosition));
    surround(dtS);
    prepare(inputs);
    integrator.step(dynamics, s, dtS);
    tidy();
    dynamics.derivatives(s, rate);
    if (dynamics.gear.broken(dynamics.attitude, s[ALT] - dynamics.groundM)) {
      freeze();
    }
  }

  private void surround(double dtS) {
    dynamics.attitude.set(s[Q0], s[Q0 + 1], s[Q0 + 2], s[Q0 + 3]);
    dynamics.groundM = groundM();
    dynamics.densityKgPerM3 = StandardAtmosphere.at(s[ALT]).densityKgPerM3();
    double heading = dynamics.attitude.headingRad();
    wind.step(
        dtS,
        s[ALT] - dynamics.groundM,
        airspeedMps(),
        StrictMath.cos(heading),
        StrictMath.sin(heading));
    dynamics.windN = wind.northMps();
    dynamics.windE = wind.eastMps();
    dynamics.windD = wind.downMps();
    dynamics.gustP = wind.gusts().rollRadPerS();
    dynamics.gustQ = wind.gusts().pitchRadPerS();
    dynamics.gustR = wind.gusts().yawRadPerS();
  }

  private double groundM() {
    double lon = Math.toDegrees(s[LON]);
    double lat = Math.toDegrees(s[LAT]);
    double elevation = terrain.elevationM(lon, lat);
    if (!Double.isFinite(elevation)) {
      String place = lat + "°, " + lon + "°: " + elevation;
      throw new IllegalStateException(
          "terrain elevation at " + place + " is not a number of metres");
    }
    return elevation;
  }

  private void prepare(ControlInputs inputs) {
    double ratio = dynamics.densityKgPerM3 / StandardAtmosphere.SEA_LEVEL_DENSITY_KG_PER_M3;
    dynamics.engine.set(inputs.throttle(), inputs.mixture(), ratio, s[SHAFT]);
    dynamics.aero.set(inputs, flapPosition);
    dynamics.gear.set(inputs);
  }

  private void tidy() {
    double norm =
        1.0
            / StrictMath.sqrt(
                s[Q0] * s[Q0]
                    + s[Q0 + 1] * s[Q0 + 1]
                    + s[Q0 + 2] * s[Q0 + 2]
                    + s[Q0 + 3] * s[Q0 + 3]);
    for (int i = Q0; i < Q0 + 4; i++) {
      s[i] *= norm;
    }
    if (s[LON] > Math.PI) {
      s[LON] -= 2.0 * Math.PI;
    } else if (s[LON] < -Math.PI) {
      s[LON] += 2.0 * Math.PI;
    }
    double slowest = dynamics.engine.running() ? 0.0 : HALTS_RAD_PER_S;
    s[SHAFT] = s[SHAFT] < slowest ? 0.0 : Math.max(0.0, s[SHAFT]);
    for (int i = 0; i < LandingGear.WHEELS; i++) {
      Wheel wheel = dynamics.gear.wheels[i];
      int tyre = TYRES + 2 * i;
      s[tyre] = wheel.boundedAlong(s[tyre]);
      s[tyre + 1] = wheel.boundedAcross(s[tyre + 1]);
    }
  }

  private void freeze() {
    crashed = true;
    dynamics.engine.stop();
    for (int i : new int[] {VN, VE, VD, P, Q, R, SHAFT}) {
      s[i] = 0.0;
    }
  }

  private double airspeedMps() {
    return StrictMath.sqrt(
        dynamics.airU * dynamics.airU
            + dynamics.airV * dynamics.airV
            + dynamics.airW * dynamics.airW);
  }

  /** The aircraft as it is now. */
  public AircraftMotion state() {
    AircraftAttitude attitude = dynamics.attitude;
    double airspeed = crashed ? 0.0 : airspeedMps();
    Air air = StandardAtmosphere.at(s[ALT]);
    double alpha = airspeed < 1.0 ? 0.0 : StrictMath.atan2(dynamics.airW, dynamics.airU);
    double beta = airspeed < 1.0 ? 0.0 : StrictMath.asin(dynamics.airV / airspeed);
    boolean onWheels = dynamics.gear.weightOnWheels();
    boolean stalled =
        !onWheels && airspeed > FLYING_MPS && Aerodynamics.stallFraction(alpha) > STALL_MIDDLE;
    return new AircraftMotion(
        (double) ticks / TICKS_PER_SECOND,
        Math.toDegrees(s[LON]),
        Math.toDegrees(s[LAT]),
        s[ALT],
        s[ALT] - dynamics.groundM - LandingGear.STANDING_M,
        attitude.rollRad(),
        attitude.pitchRad(),
        attitude.headingRad(),
        s[P],
        s[Q],
        s[R],
        s[VN],
        s[VE],
        s[VD],
        airspeed,
        air.calibratedAirspeedMps(airspeed),
        alpha,
        beta,
        s[SHAFT] / PistonEngine.RADPERS_PER_RPM,
        onWheels,
        crashed,
        stalled,
        crashed ? 1.0 : dynamics.loadFactor);
  }
}
