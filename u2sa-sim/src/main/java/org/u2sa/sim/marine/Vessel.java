package org.u2sa.sim.marine;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.atmosphere.WindField;
import org.u2sa.sim.motion.Arguments;
import org.u2sa.sim.motion.BodyAttitude;
import org.u2sa.sim.motion.RungeKutta;
import org.u2sa.sim.vehicle.BodyState;
import org.u2sa.sim.vehicle.FixedStep;
import org.u2sa.sim.vehicle.SimulatedVehicle;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Footprint;
import org.u2sa.sim.world.Water;
import org.u2sa.sim.world.Waves;
import org.u2sa.sim.world.World;

/**
 * A simulated vessel with thrusters, on or under water, drifting with the world's current, moved by
 * its waves and, if it has {@link Windage}, by its wind. Dock walls stop it. Integrates internally
 * at 200 Hz. Not thread-safe.
 */
public final class Vessel implements SimulatedVehicle {
  /** Internal integration rate [1/s]. */
  public static final int TICKS_PER_SECOND = 200;

  private final World world;
  private final Footprint footprint;
  private final List<String> names;
  private final FossenModel model;
  private final double[] state;
  private final double[] rates;
  private final boolean floats;
  private final RungeKutta integrator;
  private final Water water;
  private final boolean powerIsKnown;
  private double energyJ;
  private int towedAlong = -1;
  private double towedHeadingRad;
  private final FixedStep steps = new FixedStep(TICKS_PER_SECOND);
  private Optional<Windage> windage = Optional.empty();
  private final WindField air;
  private final Fenders fenders;

  /**
   * Creates a vessel that drifts with the water.
   *
   * @param world with water
   * @param start east, north, up [m]
   * @param headingRad clockwise from north [rad]
   * @throws IllegalArgumentException if the world has no water
   */
  public Vessel(
      Hull hull,
      List<? extends VesselActuator> actuators,
      Footprint footprint,
      World world,
      Point start,
      double headingRad) {
    water =
        world
            .water()
            .orElseThrow(() -> new IllegalArgumentException("a vessel needs a world with water"));
    this.world = world;
    this.footprint = footprint;
    names = actuators.stream().map(VesselActuator::name).collect(Collectors.toUnmodifiableList());
    model = new FossenModel(hull, actuators, water.currentAt(start), -water.surfaceM());
    state = new double[model.size()];
    rates = new double[model.size()];
    integrator = new RungeKutta(model.size());
    BodyState.place(state, start, headingRad);
    floats = hull.waterplane().isPresent();
    surround();
    powerIsKnown = model.powerW(state).isPresent();
    air = world.windAround(footprint.lengthM());
    fenders = new Fenders(world, footprint);
  }

  /** Lets the world's wind act on the hull; call before any step. */
  public Vessel inWind(Windage area) {
    windage = Optional.of(area);
    return this;
  }

  /** Computes wind and fender forces from the motion at the beginning of a step. */
  private void push() {
    double heading = BodyState.attitude(state).psi();
    double cos = StrictMath.cos(heading);
    double sin = StrictMath.sin(heading);
    Point through = BodyState.at(state, BodyState.VELOCITY);
    double north = through.x() * cos - through.y() * sin + model.drift().y();
    double east = through.x() * sin + through.y() * cos + model.drift().x();
    Point force = Point.ORIGIN;
    if (windage.isPresent()) {
      Windage area = windage.get();
      double airspeed = StrictMath.hypot(air.northMps() - north, air.eastMps() - east);
      air.step(1.0 / TICKS_PER_SECOND, area.heightM(), airspeed, cos, sin);
      force = area.on(heading, air.northMps() - north, air.eastMps() - east);
    }
    if (!fenders.isEmpty()) {
      Point ned = BodyState.at(state, BodyState.NED);
      Point place = Point.of(ned.y(), ned.x(), -ned.z());
      double turn = state[BodyState.RATES + 2];
      force =
          force.plus(
              fenders.on(new Fenders.Motion(place, heading, Point.of(east, north, 0.0), turn)));
    }
    model.push(force);
  }

  /** Lets the actuators reach their commands at once, without their lags. */
  public void settle() {
    model.settle(state);
  }

  /**
   * Lets it move along one axis only, level and on its present heading, as if on a towing carriage.
   *
   * @param axis 0: forward, 1: right, 2: down
   */
  public void tow(int axis) {
    towedAlong = axis;
    towedHeadingRad = BodyState.attitude(state).psi();
  }

  /** Starts at rest over ground instead of drifting with the current; call before any step. */
  public Vessel moored() {
    Point drift = model.drift();
    Point through = inBody(Point.of(-drift.x(), -drift.y(), 0.0));
    state[BodyState.VELOCITY] = through.x();
    state[BodyState.VELOCITY + 1] = through.y();
    state[BodyState.VELOCITY + 2] = through.z();
    return this;
  }

  private Point inBody(Point enu) {
    Point ned = Point.of(enu.y(), enu.x(), -enu.z());
    return BodyState.attitude(state).nedFromFrd().transposed().times(ned);
  }

  /** Updates current and waves at the hull; its velocity over ground does not jump. */
  private void surround() {
    Point ned = BodyState.at(state, BodyState.NED);
    Point place = Point.of(ned.y(), ned.x(), -ned.z());
    if (!water.current().isUniform()) {
      Point now = water.currentAt(place);
      Point change = inBody(now.minus(model.drift()));
      state[BodyState.VELOCITY] -= change.x();
      state[BodyState.VELOCITY + 1] -= change.y();
      state[BodyState.VELOCITY + 2] -= change.z();
      model.drift(now);
    }
    water.waves().ifPresent(waves -> model.sea(sea(waves, place)));
  }

  private FossenModel.Sea sea(Waves waves, Point place) {
    double heading = BodyState.attitude(state).psi();
    double sin = StrictMath.sin(heading);
    double cos = StrictMath.cos(heading);
    Waves.Motion around =
        waves.around(
            place,
            floats ? 0.0 : water.depthM(place.z()),
            footprint.lengthM(),
            footprint.widthM(),
            heading,
            steps.timeS());
    double east = around.slope().x();
    double north = around.slope().y();
    Point acceleration = around.acceleration();
    return new FossenModel.Sea(
        around.elevationM(),
        -StrictMath.atan(east * cos - north * sin),
        StrictMath.atan(east * sin + north * cos),
        inBody(around.velocity()),
        inBody(Point.of(acceleration.x(), acceleration.y(), 0.0)),
        inBody(acceleration));
  }

  @Override
  public List<String> actuators() {
    return names;
  }

  @Override
  public void command(String actuator, double value) {
    int index = names.indexOf(actuator);
    if (index < 0) {
      throw new IllegalArgumentException("actuator \"" + actuator + "\": expected one of " + names);
    }
    double told = Double.isNaN(value) ? 0.0 : value;
    model.command(index, Arguments.requireInside("command of " + actuator, told, -1.0, 1.0));
  }

  @Override
  public void step(double dtS) {
    steps.step(dtS, this::tick);
  }

  private void tick() {
    surround();
    push();
    integrator.step(model, state, 1.0 / TICKS_PER_SECOND);
    BodyState.normalize(state);
    if (towedAlong >= 0) {
      double along = state[BodyState.VELOCITY + towedAlong];
      Arrays.fill(state, BodyState.VELOCITY, BodyState.SIZE, 0.0);
      state[BodyState.VELOCITY + towedAlong] = along;
      BodyAttitude.write(state, BodyState.QUATERNION, 0.0, 0.0, towedHeadingRad);
    }
    if (powerIsKnown) {
      energyJ += model.powerW(state).orElseThrow() / TICKS_PER_SECOND;
    }
  }

  /** {@inheritDoc} Power of its motors. */
  @Override
  public OptionalDouble energyJ() {
    return powerIsKnown ? OptionalDouble.of(energyJ) : OptionalDouble.empty();
  }

  @Override
  public VehicleTruth truth() {
    model.derivatives(state, rates);
    return BodyState.truth(steps.timeS(), state, rates);
  }

  @Override
  public boolean isAground() {
    Point ned = BodyState.at(state, BodyState.NED);
    Point place = Point.of(ned.y(), ned.x(), -ned.z());
    return world.isAground(footprint, place, BodyState.attitude(state).psi());
  }

  @Override
  public OptionalDouble thrustN(String actuator) {
    int index = names.indexOf(actuator);
    return index < 0 ? OptionalDouble.empty() : model.thrustN(index, state);
  }

  /** Velocity relative to the water: forward, right, down [m/s]. */
  public Point throughWater() {
    return BodyState.at(state, BodyState.VELOCITY);
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
