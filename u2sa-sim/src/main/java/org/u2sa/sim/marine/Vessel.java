package org.u2sa.sim.marine;

import java.util.List;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.motion.Arguments;
import org.u2sa.sim.motion.RungeKutta;
import org.u2sa.sim.vehicle.BodyState;
import org.u2sa.sim.vehicle.FixedStep;
import org.u2sa.sim.vehicle.SimulatedVehicle;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Footprint;
import org.u2sa.sim.world.Water;
import org.u2sa.sim.world.World;

/**
 * A simulated vessel with thrusters, on or under water, drifting with the world's current.
 * Integrates internally at 200 Hz. Not thread-safe.
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
  private final RungeKutta integrator;
  private final FixedStep steps = new FixedStep(TICKS_PER_SECOND);

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
      List<VesselThruster> thrusters,
      Footprint footprint,
      World world,
      Point start,
      double headingRad) {
    Water water =
        world
            .water()
            .orElseThrow(() -> new IllegalArgumentException("a vessel needs a world with water"));
    this.world = world;
    this.footprint = footprint;
    names = thrusters.stream().map(VesselThruster::name).collect(Collectors.toUnmodifiableList());
    model =
        new FossenModel(
            hull, thrusters, water.currentNorthMps(), water.currentEastMps(), -water.surfaceM());
    state = new double[model.size()];
    rates = new double[model.size()];
    integrator = new RungeKutta(model.size());
    BodyState.place(state, start, headingRad);
  }

  /** Starts at rest over ground instead of drifting with the current; call before any step. */
  public Vessel moored() {
    Water water = world.water().orElseThrow();
    Point through =
        BodyState.attitude(state)
            .nedFromFrd()
            .transposed()
            .times(Point.of(-water.currentNorthMps(), -water.currentEastMps(), 0.0));
    state[BodyState.VELOCITY] = through.x();
    state[BodyState.VELOCITY + 1] = through.y();
    state[BodyState.VELOCITY + 2] = through.z();
    return this;
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
    integrator.step(model, state, 1.0 / TICKS_PER_SECOND);
    BodyState.normalize(state);
  }

  @Override
  public VehicleTruth truth() {
    model.derivatives(state, rates);
    return BodyState.truth(steps.timeS(), state, rates);
  }

  @Override
  public OptionalDouble thrustN(String actuator) {
    int index = names.indexOf(actuator);
    return index < 0
        ? OptionalDouble.empty()
        : OptionalDouble.of(state[FossenModel.THRUST + index]);
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
