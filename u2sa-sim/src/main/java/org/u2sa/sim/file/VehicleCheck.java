package org.u2sa.sim.file;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.vehicle.SimulatedVehicle;
import org.u2sa.sim.vehicle.VehicleTruth;

/**
 * Measures a vehicle's performance by simulating it on level ground, in still water or in calm air:
 * first each actuator alone, then all that act in the same direction together.
 */
public final class VehicleCheck {
  private static final double TICK_S = 0.05;
  private static final double PROBE_S = 1.0;
  private static final List<Double> COMMANDS = List.of(1.0, -1.0);
  private static final double LONGEST_S = 120.0;
  private static final double LOOK_BACK_S = 5.0;
  private static final double STEADY = 0.002; // change within that time, relative
  private static final double NOTHING = 0.02; // share of the strongest actuator's effect
  private static final double NO_ACCELERATION = 1e-6; // [m/s²], [rad/s²]: of rounding
  private static final double NO_TURN = 1e-4; // [rad/s]
  private static final double SIDE_EFFECT = 0.15; // share of an effect along another axis
  private static final double DEPTH_M = 100.0;

  /** Forward, right, down; turning right. */
  private enum Axis {
    SURGE("ahead", "astern"),
    SWAY("right", "left"),
    HEAVE("down", "up"),
    YAW("turning right", "turning left");

    private final String positive;
    private final String negative;

    Axis(String positive, String negative) {
      this.positive = positive;
      this.negative = negative;
    }

    double of(VehicleTruth truth) {
      Point enu = truth.velocity();
      Point body =
          truth.attitude().nedFromFrd().transposed().times(Point.of(enu.y(), enu.x(), -enu.z()));
      return switch (this) {
        case SURGE -> body.x();
        case SWAY -> body.y();
        case HEAVE -> body.z();
        case YAW -> truth.rates().z();
      };
    }
  }

  /**
   * A simulation with constant commands.
   *
   * @param peak largest acceleration along the axis [m/s²], [rad/s²]
   * @param fastest largest speed along the axis [m/s], [rad/s]
   * @param speedMps horizontal speed at the end
   * @param yawRadPerS yaw rate at the end
   */
  private record Motion(double peak, double fastest, double speedMps, double yawRadPerS) {
    double radiusM() {
      return speedMps / Math.abs(yawRadPerS);
    }
  }

  private final VehicleFile file;
  private final List<String> actuators;
  private final List<Map<Double, double[]>> effects = new ArrayList<>(); // of each actuator

  private VehicleCheck(VehicleFile file) {
    this.file = file;
    actuators = file.model().actuators();
    for (int i = 0; i < actuators.size(); i++) {
      effects.add(effects(i));
    }
  }

  /** Equipment and performance of the vehicle, as lines of text. */
  public static List<String> lines(VehicleFile file) {
    return file.model().medium() == VehicleModel.Medium.AIR
        ? AircraftCheck.lines(file)
        : new VehicleCheck(file).lines();
  }

  private List<String> lines() {
    List<String> lines = new ArrayList<>();
    lines.add(text("%s: mass %.4g kg", file.name(), file.massKg()));
    for (Axis axis : Axis.values()) {
      direction(axis, 1.0).ifPresent(lines::add);
      direction(axis, -1.0).ifPresent(lines::add);
    }
    turningCircle().ifPresent(lines::add);
    lines.addAll(parts(file));
    return lines;
  }

  /** Actuators and sensors. */
  static List<String> parts(VehicleFile file) {
    return List.of(
        "actuators: " + String.join(", ", file.model().actuators()),
        "sensors: "
            + file.sensors().stream()
                .map(each -> each.kind() + each.service().map(name -> " of " + name).orElse(""))
                .collect(Collectors.joining(", ")));
  }

  private Optional<String> direction(Axis axis, double sign) {
    double[] commands = towards(axis, sign);
    if (isZero(commands)) {
      return Optional.empty();
    }
    Motion motion = run(commands, axis, sign);
    String name = sign > 0.0 ? axis.positive : axis.negative;
    return Optional.of(
        axis == Axis.YAW
            ? text(
                "%s: %.1f deg/s, up to %.3g deg/s^2, on a circle of %.2f m radius",
                name,
                Math.toDegrees(motion.fastest()),
                Math.toDegrees(motion.peak()),
                motion.radiusM())
            : text("%s: %.3g m/s, up to %.3g m/s^2", name, motion.fastest(), motion.peak()));
  }

  private Optional<String> turningCircle() {
    double[] ahead = towards(Axis.SURGE, 1.0);
    double[] right = towards(Axis.YAW, 1.0);
    if (isZero(right) && !isZero(ahead)) {
      right = steering(ahead);
    }
    if (isZero(ahead) || isZero(right)) {
      return Optional.empty();
    }
    double[] both = new double[ahead.length];
    for (int i = 0; i < both.length; i++) {
      both[i] = Math.max(-1.0, Math.min(1.0, ahead[i] + right[i]));
    }
    Motion motion = run(both, Axis.YAW, 1.0);
    return Optional.of(
        text(
            "ahead and turning right: a circle of %.2f m radius at %.3g m/s",
            motion.radiusM(), motion.speedMps()));
  }

  /** Full commands of the actuators that turn a moving vehicle to the right without thrust. */
  private double[] steering(double[] ahead) {
    double[] commands = new double[ahead.length];
    double straight = speeds(ahead)[Axis.YAW.ordinal()];
    for (int i = 0; i < ahead.length; i++) {
      double strongest = NO_TURN;
      for (double command : ahead[i] == 0.0 ? COMMANDS : List.<Double>of()) {
        double[] steered = ahead.clone();
        steered[i] = command;
        double turning = speeds(steered)[Axis.YAW.ordinal()] - straight;
        if (turning > strongest) {
          strongest = turning;
          commands[i] = command;
        }
      }
    }
    return commands;
  }

  private static boolean isZero(double[] commands) {
    return Arrays.stream(commands).allMatch(each -> each == 0.0);
  }

  /** Full commands of the actuators that push along the axis on their own. */
  private double[] towards(Axis axis, double sign) {
    double[] commands = new double[actuators.size()];
    double most =
        effects.stream()
            .flatMap(each -> each.values().stream())
            .mapToDouble(effect -> sign * effect[axis.ordinal()])
            .max()
            .orElse(0.0);
    for (int i = 0; i < commands.length; i++) {
      double strongest = Math.max(NO_ACCELERATION, NOTHING * most);
      for (double command : COMMANDS) {
        double[] effect = effects.get(i).get(command);
        double along = sign * effect[axis.ordinal()];
        boolean isMeant = axis == Axis.YAW || along >= SIDE_EFFECT * linear(effect);
        if (isMeant && along > strongest) {
          strongest = along;
          commands[i] = command;
        }
      }
    }
    return commands;
  }

  private static double linear(double[] effect) {
    return Math.max(
        Math.abs(effect[Axis.SURGE.ordinal()]),
        Math.max(Math.abs(effect[Axis.SWAY.ordinal()]), Math.abs(effect[Axis.HEAVE.ordinal()])));
  }

  /** Mean accelerations due to one actuator's full commands, along each axis. */
  private Map<Double, double[]> effects(int actuator) {
    double[] idle = speeds(new double[actuators.size()]);
    Map<Double, double[]> effects = new LinkedHashMap<>();
    for (double command : COMMANDS) {
      double[] alone = new double[actuators.size()];
      alone[actuator] = command;
      double[] effect = speeds(alone);
      for (int k = 0; k < effect.length; k++) {
        effect[k] = (effect[k] - idle[k]) / PROBE_S;
      }
      effects.put(command, effect);
    }
    return effects;
  }

  private double[] speeds(double[] commands) {
    SimulatedVehicle vehicle = vehicle(commands);
    vehicle.step(PROBE_S);
    VehicleTruth truth = vehicle.truth();
    return Arrays.stream(Axis.values()).mapToDouble(axis -> axis.of(truth)).toArray();
  }

  private SimulatedVehicle vehicle(double[] commands) {
    Point start = file.model().isSubmerged() ? Point.of(0.0, 0.0, -DEPTH_M) : Point.ORIGIN;
    SimulatedVehicle vehicle = file.make(file.emptyWorld(), start, 0.0, 1);
    for (int i = 0; i < commands.length; i++) {
      vehicle.command(actuators.get(i), commands[i]);
    }
    return vehicle;
  }

  private Motion run(double[] commands, Axis axis, double sign) {
    SimulatedVehicle vehicle = vehicle(commands);
    double peak = 0.0;
    double fastest = 0.0;
    double before = axis.of(vehicle.truth());
    double earlier = before;
    int back = (int) Math.round(LOOK_BACK_S / TICK_S);
    int most = (int) Math.round(LONGEST_S / TICK_S);
    for (int i = 1; i <= most; i++) {
      vehicle.step(TICK_S);
      double now = axis.of(vehicle.truth());
      peak = Math.max(peak, sign * (now - before) / TICK_S);
      fastest = Math.max(fastest, sign * now);
      before = now;
      if (i % back == 0) {
        if (Math.abs(now - earlier) <= STEADY * Math.abs(now)) {
          break;
        }
        earlier = now;
      }
    }
    VehicleTruth end = vehicle.truth();
    return new Motion(peak, fastest, end.speedMps(), end.rates().z());
  }

  private static String text(String pattern, Object... values) {
    return String.format(Locale.ROOT, pattern, values);
  }
}
