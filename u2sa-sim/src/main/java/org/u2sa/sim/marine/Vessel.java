package org.u2sa.sim.marine;

import java.util.List;
import java.util.stream.Collectors;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.Rotation;
import org.u2sa.sim.motion.Arguments;
import org.u2sa.sim.motion.RungeKutta;
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
    state[FossenModel.NED] = start.y();
    state[FossenModel.NED + 1] = start.x();
    state[FossenModel.NED + 2] = -start.z();
    state[FossenModel.QUATERNION] = StrictMath.cos(headingRad / 2.0);
    state[FossenModel.QUATERNION + 3] = StrictMath.sin(headingRad / 2.0);
  }

  /** Starts at rest over ground instead of drifting with the current; call before any step. */
  public Vessel moored() {
    Water water = world.water().orElseThrow();
    Point through =
        attitude()
            .nedFromFrd()
            .transposed()
            .times(Point.of(-water.currentNorthMps(), -water.currentEastMps(), 0.0));
    state[FossenModel.VELOCITY] = through.x();
    state[FossenModel.VELOCITY + 1] = through.y();
    state[FossenModel.VELOCITY + 2] = through.z();
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
    double square = 0.0;
    for (int i = 0; i < 4; i++) {
      double each = state[FossenModel.QUATERNION + i];
      square += each * each;
    }
    double scale = 1.0 / StrictMath.sqrt(square);
    for (int i = 0; i < 4; i++) {
      state[FossenModel.QUATERNION + i] *= scale;
    }
  }

  @Override
  public VehicleTruth truth() {
    model.derivatives(state, rates);
    Attitude attitude = attitude();
    Rotation nedFromFrd = attitude.nedFromFrd();
    Point rate = at(state, FossenModel.RATES);
    Point through = at(state, FossenModel.VELOCITY);
    Point turning = // transport term ω × v of the rotating axes
        Point.of(
            rate.y() * through.z() - rate.z() * through.y(),
            rate.z() * through.x() - rate.x() * through.z(),
            rate.x() * through.y() - rate.y() * through.x());
    Point acceleration = nedFromFrd.times(at(rates, FossenModel.VELOCITY).plus(turning));
    return new VehicleTruth(
        steps.timeS(),
        enu(at(state, FossenModel.NED)),
        attitude,
        enu(at(rates, FossenModel.NED)),
        rate,
        enu(acceleration));
  }

  /** Velocity relative to the water: forward, right, down [m/s]. */
  public Point throughWater() {
    return at(state, FossenModel.VELOCITY);
  }

  private static Point at(double[] values, int index) {
    return Point.of(values[index], values[index + 1], values[index + 2]);
  }

  private static Point enu(Point ned) {
    return Point.of(ned.y(), ned.x(), -ned.z());
  }

  private Attitude attitude() {
    double w = state[FossenModel.QUATERNION];
    double x = state[FossenModel.QUATERNION + 1];
    double y = state[FossenModel.QUATERNION + 2];
    double z = state[FossenModel.QUATERNION + 3];
    double sinTheta = StrictMath.max(-1.0, StrictMath.min(1.0, 2 * (w * y - x * z)));
    double psi = StrictMath.atan2(2 * (x * y + w * z), 1 - 2 * (y * y + z * z));
    return new Attitude(
        StrictMath.atan2(2 * (y * z + w * x), 1 - 2 * (x * x + y * y)),
        StrictMath.asin(sinTheta),
        psi < 0.0 ? psi + 2.0 * StrictMath.PI : psi);
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
