package org.u2sa.sim.performance;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Supplier;
import org.u2sa.sim.marine.Vessel;
import org.u2sa.sim.vehicle.SimulatedVehicle;

/**
 * Accelerations of a vehicle at rest due to each of its actuators alone, measured in a time too
 * short to turn or gain speed, and the commands that follow from them.
 */
public final class ActuatorEffects {
  private static final double VESSEL_PROBE_S = 0.02;
  private static final double PROBE_S = 0.2; // until motors, wheels and tyres push
  private static final double NO_ACCELERATION = 1e-7; // [m/s²], [rad/s²]: of rounding
  private static final double INCIDENTAL = 0.05; // share of an actuator's largest effect
  private static final double MEANT = 0.3; // share of the largest acceleration along any axis
  private static final int HALVINGS = 14;

  private final Supplier<SimulatedVehicle> vehicles;
  private final List<String> actuators;
  private final double halfLengthM;
  private final double[] idle;
  private final double[][][] effects; // by actuator, positive and negative command, and axis
  private final PureMotion choice;

  /**
   * @param vehicles makes the vehicle at rest
   */
  public ActuatorEffects(Supplier<SimulatedVehicle> vehicles) {
    this.vehicles = vehicles;
    SimulatedVehicle vehicle = vehicles.get();
    actuators = vehicle.actuators();
    halfLengthM = vehicle.footprint().lengthM() / 2.0;
    idle = accelerations(new double[actuators.size()]);
    effects = new double[actuators.size()][][];
    for (int i = 0; i < effects.length; i++) {
      effects[i] = new double[][] {effect(i, 1.0), effect(i, -1.0)};
    }
    choice = new PureMotion(Arrays.stream(effects).map(this::meant).toArray(double[][][]::new));
  }

  /** The vehicle at rest, with these commands. */
  public SimulatedVehicle vehicle(double[] commands) {
    SimulatedVehicle vehicle = vehicles.get();
    for (int i = 0; i < commands.length; i++) {
      vehicle.command(actuators.get(i), commands[i]);
    }
    return vehicle;
  }

  /** Whether an actuator does nothing at rest, such as a rudder. */
  public boolean isIdleAtRest(int actuator) {
    return Arrays.stream(effects[actuator])
        .flatMapToDouble(Arrays::stream)
        .allMatch(effect -> Math.abs(effect) < NO_ACCELERATION);
  }

  /**
   * Commands that accelerate the vehicle most along an axis; all 0 if it accelerates along the axis
   * only as a side effect.
   *
   * @param sign direction along the axis, 1 or −1
   * @param axes axes along which it can move
   * @param others axes along which it should not accelerate, in order of importance
   */
  public double[] towards(
      MotionAxis axis, double sign, List<MotionAxis> axes, List<MotionAxis> others) {
    List<Integer> cancelled = new ArrayList<>();
    others.forEach(each -> cancelled.add(each.ordinal()));
    double[] shares = choice.along(axis.ordinal(), sign, cancelled);
    double[] all = PureMotion.sum(shares, effects);
    double most = NO_ACCELERATION / MEANT;
    for (MotionAxis each : axes) {
      most = Math.max(most, Math.abs(along(all, each)));
    }
    double[] commands = new double[shares.length];
    if (sign * along(all, axis) >= MEANT * most) {
      Arrays.setAll(commands, i -> command(i, shares[i]));
    }
    return commands;
  }

  /** Half the vehicle's length [m]. */
  public double halfLengthM() {
    return halfLengthM;
  }

  /** An actuator's effects without those that are incidental, such as of a slight misalignment. */
  private double[][] meant(double[][] each) {
    double[][] meant = new double[each.length][];
    for (int side = 0; side < each.length; side++) {
      double[] effect = each[side];
      double[] scaled =
          Arrays.stream(MotionAxis.values()).mapToDouble(axis -> along(effect, axis)).toArray();
      double most = Arrays.stream(scaled).map(Math::abs).max().orElseThrow();
      meant[side] =
          Arrays.stream(scaled).map(e -> Math.abs(e) > INCIDENTAL * most ? e : 0.0).toArray();
    }
    return meant;
  }

  /** Acceleration along an axis [m/s²]; for a rotation, of the hull's ends. */
  private double along(double[] accelerations, MotionAxis axis) {
    double along = accelerations[axis.ordinal()];
    return axis.isRotation() ? halfLengthM * along : along;
  }

  /** Command with which an actuator has a share of its full effect. */
  private double command(int actuator, double share) {
    if (share == Math.rint(share)) {
      return share;
    }
    double[] full = effects[actuator][share > 0.0 ? 0 : 1];
    double low = 0.0;
    double high = Math.signum(share);
    for (int i = 0; i < HALVINGS; i++) {
      double middle = (low + high) / 2.0;
      if (product(effect(actuator, middle), full) < Math.abs(share) * product(full, full)) {
        low = middle;
      } else {
        high = middle;
      }
    }
    return high;
  }

  private static double product(double[] a, double[] b) {
    double sum = 0.0;
    for (int k = 0; k < a.length; k++) {
      sum += a[k] * b[k];
    }
    return sum;
  }

  private double[] effect(int actuator, double command) {
    double[] alone = new double[actuators.size()];
    alone[actuator] = command;
    double[] effect = accelerations(alone);
    Arrays.setAll(effect, k -> effect[k] - idle[k]);
    return effect;
  }

  /** Mean accelerations along each axis. */
  private double[] accelerations(double[] commands) {
    SimulatedVehicle vehicle = vehicle(commands);
    double probeS = PROBE_S;
    if (vehicle instanceof Vessel vessel) {
      vessel.settle();
      probeS = VESSEL_PROBE_S;
    }
    vehicle.step(probeS);
    double[] rates = MotionAxis.velocities(vehicle.truth());
    for (int k = 0; k < rates.length; k++) {
      rates[k] /= probeS;
    }
    return rates;
  }
}
