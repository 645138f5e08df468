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

import java.util.List;
import java.util.Objects;
import java.util.OptionalDouble;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.atmosphere.StandardAtmosphere;
import org.u2sa.sim.atmosphere.Wind;
import org.u2sa.sim.atmosphere.WindField;
import org.u2sa.sim.gear.Wheel;
import org.u2sa.sim.motion.BodyAttitude;
import org.u2sa.sim.motion.RungeKutta;
import org.u2sa.sim.vehicle.FixedStep;
import org.u2sa.sim.vehicle.SimulatedVehicle;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Footprint;
import org.u2sa.sim.world.World;

/** A simulated Cessna 172: controls in, state out. Integrates internally at 120 Hz. */
public final class Cessna172 implements SimulatedVehicle {
  /** Internal integration rate [1/s]. */
  public static final int TICKS_PER_SECOND = 120;

  /** Names of its controls. */
  public static final List<String> CONTROLS = ControlInputs.NAMES;

  /** Collision outline: nose, wing tips and tail, from wheels to fin. */
  private static final Footprint FOOTPRINT =
      new Footprint(
          List.of(
              Point.of(1.75, 0.0, 0.0),
              Point.of(0.0, 5.48, 0.0),
              Point.of(-5.3, 0.0, 0.0),
              Point.of(0.0, -5.48, 0.0)),
          -LandingGear.STANDING_M,
          1.45);

  private static final double FLAP_TRAVEL_S = 7.0; // for the full 30°
  private static final double FLYING_MPS = 10.0; // below this airspeed no stall is reported
  private static final double STALL_MIDDLE = 0.5;
  private static final double HALTS_RAD_PER_S =
      2.0; // a stopped engine below this speed no longer turns

  private final World world;
  private final WindField wind;
  private final FlightDynamics dynamics;
  private final Footprint footprint;
  private final RungeKutta integrator = new RungeKutta(FlightDynamics.SIZE);
  private final double[] rate = new double[FlightDynamics.SIZE];
  private final double[] s;
  private double flapPosition;
  private final FixedStep steps = new FixedStep(TICKS_PER_SECOND);
  private final Runnable tick = this::tick;
  private ControlInputs held = ControlInputs.neutral();
  private boolean crashed;
  private double energyJ;

  private Cessna172(
      double[] start, World world, FlightDynamics dynamics, Footprint footprint, double flaps) {
    this.s = start;
    this.world = Objects.requireNonNull(world, "world");
    this.wind = world.windAround(Airframe.SPAN_M);
    this.dynamics = dynamics;
    this.footprint = footprint;
    this.flapPosition = flaps;
    surround(1.0 / TICKS_PER_SECOND);
    prepare(held);
    dynamics.derivatives(s, rate);
  }

  /** Creates an aircraft on its wheels, on level ground at the start's elevation. */
  public static Cessna172 onRunway(RunwayStart start, Wind wind, boolean engineRunning) {
    Geodetic place = new Geodetic(start.longitudeDeg(), start.latitudeDeg(), start.elevationM());
    return onRunway(start, World.at(place).with(wind), engineRunning);
  }

  /** Creates an aircraft on its wheels at the start's elevation, over the given terrain. */
  public static Cessna172 onRunway(RunwayStart start, World world, boolean engineRunning) {
    return new Cessna172(
        InitialState.standing(start, engineRunning),
        world,
        new FlightDynamics(new PistonEngine(engineRunning)),
        FOOTPRINT,
        0.0);
  }

  /**
   * Creates an aircraft with a different loading on its wheels.
   *
   * @param massKg mass, up to about the maximum take-off mass of 1088.6 kg, the design mass of the
   *     gear
   * @param inertia moments of inertia in roll, pitch and yaw [kg m²]
   */
  public static Cessna172 onRunway(
      RunwayStart start,
      World world,
      boolean engineRunning,
      double massKg,
      Point inertia,
      Footprint footprint) {
    return new Cessna172(
        InitialState.standing(start, engineRunning),
        world,
        new FlightDynamics(new PistonEngine(engineRunning), massKg, inertia),
        footprint,
        0.0);
  }

  /** Creates an airborne aircraft above level ground. */
  public static Cessna172 inFlight(FlightStart start, Wind wind) {
    Geodetic below =
        new Geodetic(start.longitudeDeg(), start.latitudeDeg(), start.groundElevationM());
    return inFlight(start, World.at(below).with(wind));
  }

  /** Creates an airborne aircraft; its airspeed is relative to the steady wind at its position. */
  public static Cessna172 inFlight(FlightStart start, World world) {
    double[] s = InitialState.flying(start, world.wind());
    FlightDynamics dynamics = new FlightDynamics(new PistonEngine(start.engineRpm() > 0.0));
    return new Cessna172(s, world, dynamics, FOOTPRINT, start.flaps());
  }

  /**
   * Cranks the engine until it idles; mixture cut-off stops it. No effect if it is running or the
   * aircraft has crashed.
   */
  public void startEngine() {
    if (!crashed && !dynamics.engine.running()) {
      s[SHAFT] = PistonEngine.IDLE_RPM * PistonEngine.RADPERS_PER_RPM;
      dynamics.engine.start();
    }
  }

  /** Applies these inputs until further notice. */
  public void hold(ControlInputs inputs) {
    held = Objects.requireNonNull(inputs, "inputs");
  }

  /** Applies these inputs until further notice, and steps. */
  public void step(ControlInputs inputs, double dtS) {
    hold(inputs);
    step(dtS);
  }

  @Override
  public void step(double dtS) {
    steps.step(dtS, tick);
  }

  @Override
  public List<String> actuators() {
    return ControlInputs.NAMES;
  }

  @Override
  public void command(String actuator, double value) {
    held = held.with(actuator, value);
  }

  private void tick() {
    if (crashed) {
      return;
    }
    double dtS = 1.0 / TICKS_PER_SECOND;
    double flapStep = dtS / FLAP_TRAVEL_S;
    flapPosition += Math.max(-flapStep, Math.min(flapStep, held.flaps() - flapPosition));
    surround(dtS);
    prepare(held);
    integrator.step(dynamics, s, dtS);
    tidy();
    dynamics.derivatives(s, rate);
    energyJ += Math.max(0.0, dynamics.engine.torqueNm(s[SHAFT])) * s[SHAFT] * dtS;
    if (dynamics.gear.broken(dynamics.attitude, s[ALT] - dynamics.groundM)) {
      freeze();
    }
  }

  /** {@inheritDoc} Counts the work of the engine's shaft. */
  @Override
  public OptionalDouble energyJ() {
    return OptionalDouble.of(energyJ);
  }

  private void surround(double dtS) {
    dynamics.attitude.set(s[Q0], s[Q0 + 1], s[Q0 + 2], s[Q0 + 3]);
    double longitude = Math.toDegrees(s[LON]);
    double latitude = Math.toDegrees(s[LAT]);
    dynamics.groundM = world.elevationM(longitude, latitude);
    Point slope = world.slope(longitude, latitude);
    dynamics.slope(slope.y(), slope.x(), s[LAT], s[LON]);
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

  /** Current state. */
  public AircraftMotion state() {
    BodyAttitude attitude = dynamics.attitude;
    double airspeed = crashed ? 0.0 : airspeedMps();
    StandardAtmosphere.Air air = StandardAtmosphere.at(s[ALT]);
    double alpha = airspeed < 1.0 ? 0.0 : StrictMath.atan2(dynamics.airW, dynamics.airU);
    double beta = airspeed < 1.0 ? 0.0 : StrictMath.asin(dynamics.airV / airspeed);
    boolean onWheels = dynamics.gear.weightOnWheels();
    boolean stalled =
        !onWheels && airspeed > FLYING_MPS && Aerodynamics.stallFraction(alpha) > STALL_MIDDLE;
    return new AircraftMotion(
        steps.timeS(),
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

  @Override
  public VehicleTruth truth() {
    BodyAttitude attitude = dynamics.attitude;
    Geodetic place = new Geodetic(Math.toDegrees(s[LON]), Math.toDegrees(s[LAT]), s[ALT]);
    return new VehicleTruth(
        steps.timeS(),
        world.plane().point(place),
        new Attitude(attitude.rollRad(), attitude.pitchRad(), attitude.headingRad()),
        Point.of(s[VE], s[VN], -s[VD]),
        Point.of(s[P], s[Q], s[R]),
        crashed ? Point.ORIGIN : Point.of(rate[VE], rate[VN], -rate[VD]));
  }

  /** {@inheritDoc} Includes gusts. */
  @Override
  public Point air() {
    AircraftMotion motion = state();
    double alongPlaneMps = motion.trueAirspeedMps() * StrictMath.cos(motion.sideslipRad());
    Point throughAir = // forward, left, down
        Point.of(
            alongPlaneMps * StrictMath.cos(motion.angleOfAttackRad()),
            -motion.trueAirspeedMps() * StrictMath.sin(motion.sideslipRad()),
            alongPlaneMps * StrictMath.sin(motion.angleOfAttackRad()));
    VehicleTruth truth = truth();
    Point ned = truth.attitude().nedOf(throughAir);
    return truth.velocity().minus(Point.of(ned.y(), ned.x(), -ned.z()));
  }

  /** {@inheritDoc} Also true after a crash. */
  @Override
  public boolean isAground() {
    return crashed;
  }

  @Override
  public Footprint footprint() {
    return footprint;
  }

  @Override
  public World world() {
    return world;
  }
}
