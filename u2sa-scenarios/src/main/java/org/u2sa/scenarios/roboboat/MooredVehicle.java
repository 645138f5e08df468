package org.u2sa.scenarios.roboboat;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.vehicle.SimulatedVehicle;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Footprint;
import org.u2sa.sim.world.World;

/**
 * A boat that the cushion of a dock holds once its bow is in it, until its thrusters push back. It
 * does not move meanwhile. Not thread-safe, but for {@link #isHeld}.
 */
final class MooredVehicle implements SimulatedVehicle {
  private static final double SHORT_M = 0.15; // of the berth, where the cushion begins
  private static final double DEEP_M = 0.4; // beyond the berth
  private static final double ASIDE_M = 0.8;
  private static final double TURN_RAD = Math.toRadians(45.0);
  private static final double REVERSE = -0.1; // sum of the commands that leaves
  private static final double CLEAR_M = 1.0; // from the berth, to be held again

  /** Makes a boat at rest. */
  @FunctionalInterface
  interface Maker {
    /**
     * @param place east, north, up [m]
     * @param headingRad clockwise from north
     */
    SimulatedVehicle make(Point place, double headingRad);
  }

  private final Maker maker;
  private final Point berth; // north, east [m]
  private final double headingRad;
  private final Map<String, Double> commands = new HashMap<>();
  private volatile boolean held;
  private double beforeS; // time before the present boat, and in the dock
  private boolean isReleased;
  private SimulatedVehicle boat; // another one after each time in the dock, at rest

  /**
   * @param boat at its start
   * @param berth place of the boat when it is docked: north, east [m]
   * @param headingRad its heading there, clockwise from north
   */
  MooredVehicle(Maker maker, SimulatedVehicle boat, Point berth, double headingRad) {
    this.maker = maker;
    this.boat = boat;
    this.berth = berth;
    this.headingRad = headingRad;
  }

  /** Whether the dock holds the boat now. Thread-safe. */
  boolean isHeld() {
    return held;
  }

  @Override
  public List<String> actuators() {
    return boat.actuators();
  }

  @Override
  public void command(String actuator, double value) {
    commands.put(actuator, value);
    boat.command(actuator, value);
  }

  @Override
  public void step(double dtS) {
    if (held) {
      beforeS += dtS;
      if (pushed() < REVERSE) {
        release();
      }
      return;
    }
    boat.step(dtS);
    VehicleTruth now = boat.truth();
    double north = now.position().y() - berth.x();
    double east = now.position().x() - berth.y();
    isReleased &= Math.hypot(north, east) < CLEAR_M;
    double ahead = north * Math.cos(headingRad) + east * Math.sin(headingRad);
    double aside = east * Math.cos(headingRad) - north * Math.sin(headingRad);
    double turn = Math.IEEEremainder(now.headingRad() - headingRad, 2.0 * Math.PI);
    held =
        !isReleased
            && ahead > -SHORT_M
            && ahead < DEEP_M
            && Math.abs(aside) < ASIDE_M
            && Math.abs(turn) < TURN_RAD;
  }

  /** Sum of the commands; a released actuator, whose command is NaN, does not count. */
  private double pushed() {
    return commands.values().stream()
        .mapToDouble(Double::doubleValue)
        .filter(command -> !Double.isNaN(command))
        .sum();
  }

  private void release() {
    VehicleTruth now = boat.truth();
    beforeS += now.timeS();
    boat = maker.make(now.position(), now.headingRad());
    commands.forEach(boat::command);
    held = false;
    isReleased = true;
  }

  @Override
  public VehicleTruth truth() {
    VehicleTruth now = boat.truth();
    double timeS = now.timeS() + beforeS;
    return held
        ? new VehicleTruth(
            timeS, now.position(), now.attitude(), Point.ORIGIN, Point.ORIGIN, Point.ORIGIN)
        : new VehicleTruth(
            timeS, now.position(), now.attitude(), now.velocity(), now.rates(), now.acceleration());
  }

  @Override
  public Footprint footprint() {
    return boat.footprint();
  }

  @Override
  public World world() {
    return boat.world();
  }

  @Override
  public OptionalDouble thrustN(String actuator) {
    return boat.thrustN(actuator);
  }

  @Override
  public OptionalDouble energyJ() {
    return boat.energyJ();
  }

  @Override
  public Point air() {
    return boat.air();
  }
}
