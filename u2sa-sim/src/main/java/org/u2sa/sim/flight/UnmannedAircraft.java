package org.u2sa.sim.flight;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Gravity;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.atmosphere.StandardAtmosphere;
import org.u2sa.sim.atmosphere.WindField;
import org.u2sa.sim.gear.Wheel;
import org.u2sa.sim.motion.BodyAttitude;
import org.u2sa.sim.motion.RungeKutta;
import org.u2sa.sim.vehicle.BodyState;
import org.u2sa.sim.vehicle.FixedStep;
import org.u2sa.sim.vehicle.SimulatedVehicle;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Footprint;
import org.u2sa.sim.world.Terrain;
import org.u2sa.sim.world.World;

/**
 * A simulated multirotor or small fixed-wing aircraft. Integrates internally at 400 Hz. A broken
 * leg, or a centre of gravity at the ground, ends the flight: the aircraft stays where it is. Not
 * thread-safe.
 */
public final class UnmannedAircraft implements SimulatedVehicle {
  /** Internal integration rate [1/s]. */
  public static final int TICKS_PER_SECOND = 400;

  private static final double TICK_S = 1.0 / TICKS_PER_SECOND;

  private final AirLoads loads;
  private final Footprint footprint;
  private final World world;
  private final WindField wind;
  private final List<Wheel> wheels;
  private final double breaksAtM; // compression of a leg
  private final FreeBody body;
  private final RungeKutta integrator;
  private final double[] state;
  private final double[] rate;
  private final FixedStep steps = new FixedStep(TICKS_PER_SECOND);
  private boolean crashed;
  private double energyJ;
  private Optional<Catapult> catapult = Optional.empty(); // on which it waits for launch

  private UnmannedAircraft(
      MassProperties mass,
      AirLoads loads,
      List<Wheel> wheels,
      double breaksAtM,
      Footprint footprint,
      World world,
      Point start,
      double headingRad) {
    this.loads = loads;
    this.footprint = footprint;
    this.world = world;
    wind = world.windAround(loads.spanM());
    this.wheels = List.copyOf(wheels);
    this.breaksAtM = breaksAtM;
    body = new FreeBody(mass, loads, wheels, Gravity.STANDARD_MPS2);
    integrator = new RungeKutta(body.size());
    state = new double[body.size()];
    rate = new double[body.size()];
    BodyState.place(state, start, headingRad);
    surround();
    body.derivatives(state, rate);
  }

  /**
   * Creates a multirotor at rest, rotors stopped. The command 0…1 of a rotor is the fraction of its
   * full speed.
   *
   * @param frameDrag drag of the frame along each axis [N s²/m²]
   * @param legs landing gear
   * @param start centre of gravity: east, north, up [m]
   * @param headingRad clockwise from north [rad]
   */
  public static UnmannedAircraft multirotor(
      MassProperties mass,
      List<Rotor> rotors,
      Point frameDrag,
      List<LandingLeg> legs,
      Footprint footprint,
      World world,
      Point start,
      double headingRad) {
    AirLoads loads = new Rotors(rotors, frameDrag);
    List<Wheel> wheels = LandingLeg.wheels(legs, mass.massKg());
    return new UnmannedAircraft(
        mass, loads, wheels, LandingLeg.BREAKS_AT_M, footprint, world, start, headingRad);
  }

  /**
   * Creates a fixed-wing aircraft at rest.
   *
   * @param legs landing gear
   * @param start centre of gravity: east, north, up [m]
   * @param headingRad clockwise from north [rad]
   */
  public static UnmannedAircraft fixedWing(
      MassProperties mass,
      WingCoefficients wing,
      List<ControlSurface> surfaces,
      ElectricPropeller propeller,
      List<LandingLeg> legs,
      Footprint footprint,
      World world,
      Point start,
      double headingRad) {
    List<Wheel> wheels = LandingLeg.wheels(legs, mass.massKg());
    AirLoads loads = new Wings(wing, surfaces, propeller, wheels);
    return new UnmannedAircraft(
        mass, loads, wheels, LandingLeg.BREAKS_AT_M, footprint, world, start, headingRad);
  }

  /**
   * Creates an aircraft at rest whose loads determine its mass, with legs that never break.
   *
   * @param wheels its landing gear, which the loads may steer and brake
   * @param start centre of gravity: east, north, up [m]
   * @param headingRad clockwise from north [rad]
   */
  public static UnmannedAircraft of(
      AirLoads loads,
      List<Wheel> wheels,
      Footprint footprint,
      World world,
      Point start,
      double headingRad) {
    return new UnmannedAircraft(
        loads.mass().orElseThrow(),
        loads,
        wheels,
        Double.POSITIVE_INFINITY,
        footprint,
        world,
        start,
        headingRad);
  }

  /**
   * Sets the aircraft's attitude and motion: call before the first step.
   *
   * @param velocity over ground: forward, right, down in body axes [m/s]
   */
  public void fly(Attitude attitude, Point velocity) {
    BodyAttitude.write(
        state, BodyState.QUATERNION, attitude.phi(), attitude.theta(), attitude.psi());
    state[BodyState.VELOCITY] = velocity.x();
    state[BodyState.VELOCITY + 1] = velocity.y();
    state[BodyState.VELOCITY + 2] = velocity.z();
    body.derivatives(state, rate);
  }

  /**
   * Holds the aircraft until its motor runs, then launches it: call before the first step.
   *
   * @param how launch speed and angle
   */
  public void waitOn(Catapult how) {
    catapult = Optional.of(how);
    BodyAttitude.write(state, BodyState.QUATERNION, 0.0, how.angleRad(), truth().headingRad());
    Arrays.fill(rate, 0.0);
  }

  /** Launches the aircraft immediately, without a stroke. */
  public void launch(Catapult how) {
    waitOn(how);
    state[BodyState.VELOCITY] = how.speedMps();
    catapult = Optional.empty();
    body.derivatives(state, rate);
  }

  @Override
  public List<String> actuators() {
    return loads.actuators();
  }

  @Override
  public void command(String actuator, double value) {
    loads.command(indexOf(actuator), Double.isNaN(value) ? 0.0 : value);
  }

  /**
   * Breaks a rotor, a surface or a motor.
   *
   * @param share remaining fraction of its effect, 0…1
   * @throws IllegalArgumentException if the actuator is unknown or the share out of range
   */
  public void weaken(String actuator, double share) {
    loads.weaken(indexOf(actuator), share);
  }

  private int indexOf(String actuator) {
    int index = loads.actuators().indexOf(actuator);
    if (index < 0) {
      throw new IllegalArgumentException(
          "actuator \"" + actuator + "\": expected one of " + loads.actuators());
    }
    return index;
  }

  /** {@inheritDoc} For rotors, shaft power; for a propeller, the power of its motor. */
  @Override
  public OptionalDouble energyJ() {
    return OptionalDouble.of(energyJ);
  }

  @Override
  public void step(double dtS) {
    steps.step(dtS, this::tick);
  }

  /** {@inheritDoc} Also true after a crash: a leg has broken, or it has tipped over. */
  @Override
  public boolean isAground() {
    return crashed;
  }

  private void tick() {
    if (crashed || isHeld()) {
      return;
    }
    surround();
    loads.tick(state, rate, FreeBody.ACTUATORS, body.air, TICK_S);
    loads.mass().ifPresent(body::weigh);
    integrator.step(body, state, TICK_S);
    BodyState.normalize(state);
    body.boundTyres(state);
    body.derivatives(state, rate);
    energyJ += loads.powerW(state, FreeBody.ACTUATORS, body.air) * TICK_S;
    crashed =
        state[BodyState.NED + 2] > body.groundDown
            || wheels.stream().anyMatch(wheel -> wheel.compressionM() > breaksAtM);
    if (crashed) {
      for (int i = BodyState.VELOCITY; i < state.length; i++) {
        state[i] = 0.0;
      }
      Arrays.fill(rate, 0.0);
    }
  }

  private boolean isHeld() {
    if (catapult.isEmpty()) {
      return false;
    }
    boolean slides = state[BodyState.VELOCITY] > 0.0 || loads.isDriven();
    if (slides) {
      slide(catapult.get());
    }
    return true;
  }

  /** Runs one tick along the catapult, at constant acceleration. */
  private void slide(Catapult how) {
    body.derivatives(state, rate);
    for (int i = FreeBody.ACTUATORS; i < FreeBody.ACTUATORS + loads.actuators().size(); i++) {
      state[i] += rate[i] * TICK_S;
    }
    Arrays.fill(rate, BodyState.QUATERNION, rate.length, 0.0);
    rate[BodyState.VELOCITY] = how.accelerationMps2();
    state[BodyState.VELOCITY] += how.accelerationMps2() * TICK_S;
    BodyState.kinematics(state, rate, 0.0, 0.0);
    for (int i = BodyState.NED; i < BodyState.NED + 3; i++) {
      state[i] += rate[i] * TICK_S;
    }
    if (state[BodyState.VELOCITY] >= how.speedMps()) {
      catapult = Optional.empty();
    }
  }

  private void surround() {
    body.observe(state);
    double altitude = world.plane().origin().altitudeM() - state[BodyState.NED + 2];
    body.air.standard = StandardAtmosphere.at(altitude);
    body.air.densityKgPerM3 = body.air.standard.densityKgPerM3();
    double north = state[BodyState.NED];
    double east = state[BodyState.NED + 1];
    Terrain ground = world.terrain();
    body.groundDown = -ground.heightM(east, north);
    body.slope(ground.riseNorth(east, north), ground.riseEast(east, north), north, east);
    body.air.heightM = body.groundDown - state[BodyState.NED + 2];
    double heading = body.attitude.headingRad();
    wind.step(
        TICK_S,
        body.groundDown - state[BodyState.NED + 2],
        body.air.speedMps(),
        StrictMath.cos(heading),
        StrictMath.sin(heading));
    body.air.windN = wind.northMps();
    body.air.windE = wind.eastMps();
    body.air.windD = wind.downMps();
    body.air.gustP = wind.gusts().rollRadPerS();
    body.air.gustQ = wind.gusts().pitchRadPerS();
    body.air.gustR = wind.gusts().yawRadPerS();
  }

  /** Whether a leg touches the ground. */
  public boolean stands() {
    return body.stands();
  }

  /** Velocity through the air: forward, right, down in body axes [m/s]. */
  public Point throughAir() {
    body.observe(state);
    return Point.of(body.air.u, body.air.v, body.air.w);
  }

  @Override
  public Point air() {
    return Point.of(body.air.windE, body.air.windN, -body.air.windD);
  }

  @Override
  public VehicleTruth truth() {
    return BodyState.truth(steps.timeS(), state, rate);
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
