package org.u2sa.sim.file;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.guide.Carriage;
import org.u2sa.sim.guide.Guide;
import org.u2sa.sim.marine.Vessel;
import org.u2sa.sim.performance.ActuatorEffects;
import org.u2sa.sim.performance.MotionAxis;
import org.u2sa.sim.performance.OpenLoop;
import org.u2sa.sim.performance.OpenLoop.Motion;
import org.u2sa.sim.vehicle.SimulatedVehicle;

/**
 * Describes a vehicle's performance. That of ground vehicles and vessels is measured by simulating
 * them on level ground or in still water with constant commands, full unless they would move it
 * along other axes too.
 */
public final class VehicleCheck {
  private static final List<Double> FULL = List.of(1.0, -1.0);
  private static final double NO_TURN_RADPS = 1e-4;
  private static final double CURVED_RADPS = Math.toRadians(1.0);
  private static final double ON_THE_SPOT = 0.1; // radius by half the length
  private static final double STEERS = 0.1; // share of the turn
  private static final double UPRIGHT_S = 640.0; // within which a vehicle settles or overturns
  private static final int HALVINGS = 7;
  private static final double DEPTH_M = 10_000.0; // a vehicle that rises all the time stays under
  private static final double FULL_PERCENT = 100.0;

  private final VehicleFile file;
  private final ActuatorEffects effects;

  private VehicleCheck(VehicleFile file) {
    this.file = file;
    Point start = file.model().isSubmerged() ? Point.of(0.0, 0.0, -DEPTH_M) : Point.ORIGIN;
    effects = new ActuatorEffects(() -> file.make(file.emptyWorld(), start, 0.0, 1));
  }

  /** Equipment and performance of the vehicle, as lines of text. */
  public static List<String> lines(VehicleFile file) {
    List<String> lines = new ArrayList<>();
    lines.add(text("%s: mass %.4g kg", file.name(), file.massKg()));
    if (file.model().medium() == VehicleModel.Medium.AIR) {
      lines.addAll(AircraftCheck.lines(file.model()));
    } else if (file.model() instanceof FixedBaseModel base) {
      lines.addAll(guided(file, base.guide()));
    } else {
      lines.addAll(new VehicleCheck(file).motions());
    }
    lines.add("actuators: " + String.join(", ", file.model().actuators()));
    lines.add(
        "sensors: "
            + file.sensors().stream()
                .map(each -> each.kind() + each.service().map(name -> " of " + name).orElse(""))
                .collect(Collectors.joining(", ")));
    return lines;
  }

  /** From one end of the guide to the other, and back. */
  private static List<String> guided(VehicleFile file, Guide guide) {
    Point way = guide.direction();
    MotionAxis axis = MotionAxis.SURGE;
    double along = way.x();
    if (Math.abs(way.y()) > Math.abs(along)) {
      axis = MotionAxis.SWAY;
      along = way.y();
    }
    if (Math.abs(way.z()) > Math.abs(along)) {
      axis = MotionAxis.HEAVE;
      along = way.z();
    }
    SimulatedVehicle carriage = file.make(file.emptyWorld(), Point.ORIGIN, 0.0, 1);
    carriage.command(Carriage.DRIVE, -1.0);
    OpenLoop.run(carriage, axis, 1.0);
    List<String> lines = new ArrayList<>();
    for (double command : FULL) {
      carriage.command(Carriage.DRIVE, command);
      double sign = Math.signum(along * command);
      Motion motion = OpenLoop.run(carriage, axis, sign);
      double fastest = motion.fastest() / Math.abs(along);
      double peak = motion.peak() / Math.abs(along);
      lines.add(text("%s: %.3g m/s, up to %.3g m/s^2", axis.name(sign), fastest, peak));
    }
    return lines;
  }

  private List<String> motions() {
    List<String> lines = new ArrayList<>();
    for (MotionAxis axis : axes()) {
      direction(axis, 1.0).ifPresent(lines::add);
      direction(axis, -1.0).ifPresent(lines::add);
    }
    turningCircle().ifPresent(lines::add);
    return lines;
  }

  /** Axes along which a vehicle of its kind can move. */
  private List<MotionAxis> axes() {
    if (file.model().medium() == VehicleModel.Medium.GROUND) {
      return List.of(MotionAxis.SURGE, MotionAxis.YAW);
    }
    return file.model().isSubmerged()
        ? List.of(MotionAxis.SURGE, MotionAxis.SWAY, MotionAxis.HEAVE, MotionAxis.YAW)
        : List.of(MotionAxis.SURGE, MotionAxis.SWAY, MotionAxis.YAW);
  }

  private Optional<String> direction(MotionAxis axis, double sign) {
    double[] commands = towards(axis, sign);
    if (isZero(commands)) {
      return Optional.empty();
    }
    Motion motion = OpenLoop.run(effects.vehicle(commands), axis, sign);
    boolean turns = axis == MotionAxis.YAW;
    String unit = turns ? "deg" : "m";
    double scale = turns ? Math.toDegrees(1.0) : 1.0;
    String alone = alone(commands, axis, sign, motion);
    String kept = "";
    if (!turns && !alone.isEmpty() && effects.vehicle(commands) instanceof Vessel vessel) {
      vessel.tow(axis.ordinal());
      motion = OpenLoop.run(vessel, axis, sign);
      kept = " if kept on course";
    }
    boolean isMeasured = motion.isSteady() || motion.end() == OpenLoop.End.CHANGING;
    return Optional.of(
        axis.name(sign)
            + (isMeasured
                ? text(": %.3g %s/s%s", scale * motion.last(), unit, kept)
                : ": no steady motion")
            + text(", up to %.3g %s/s^2", scale * motion.peak(), unit)
            + (alone.isEmpty() ? "" : ", " + alone));
  }

  /** What distinguishes the motion from a steady one along the axis. */
  private String alone(double[] commands, MotionAxis axis, double sign, Motion motion) {
    return switch (motion.end()) {
      case DIVERGED -> "its motion diverges: do forces and drag fit each other?";
      case OVERTURNED ->
          text(
              "without control it is unstable above %.0f %% of these commands",
              FULL_PERCENT * steadyShare(commands, axis, sign));
      case OSCILLATING -> "without control it oscillates";
      case CHANGING -> text("not steady after %.0f s", OpenLoop.LONGEST_S);
      case STEADY -> {
        if (axis == MotionAxis.YAW) {
          yield motion.radiusM() < ON_THE_SPOT * effects.halfLengthM()
              ? "on the spot"
              : text("on a circle of %.3g m radius", motion.radiusM());
        }
        yield Math.abs(motion.yawRadPerS()) < CURVED_RADPS
            ? ""
            : text(
                "without control it turns: a circle of %.3g m radius at %.3g m/s",
                motion.radiusM(), motion.speedMps());
      }
    };
  }

  /** Largest share of the commands with which the motion is steady. */
  private double steadyShare(double[] commands, MotionAxis axis, double sign) {
    double low = 0.0;
    double high = 1.0;
    for (int i = 0; i < HALVINGS; i++) {
      double middle = (low + high) / 2.0;
      double[] less = scaled(commands, middle);
      if (OpenLoop.run(effects.vehicle(less), axis, sign, UPRIGHT_S).isSteady()) {
        low = middle;
      } else {
        high = middle;
      }
    }
    return low;
  }

  private static double[] scaled(double[] commands, double share) {
    return Arrays.stream(commands).map(each -> share * each).toArray();
  }

  private Optional<String> turningCircle() {
    double[] commands = towards(MotionAxis.SURGE, 1.0);
    if (isZero(commands)) {
      return Optional.empty();
    }
    double[] right = effects.towards(MotionAxis.YAW, 1.0, axes(), List.of());
    double[] left = effects.towards(MotionAxis.YAW, -1.0, axes(), List.of());
    for (int i = 0; i < commands.length; i++) {
      double change = right[i] == 0.0 ? -left[i] : right[i];
      commands[i] = Math.max(-1.0, Math.min(1.0, commands[i] + change));
    }
    steer(commands);
    Motion motion = OpenLoop.run(effects.vehicle(commands), MotionAxis.YAW, 1.0);
    if (!motion.isSteady()) {
      String alone = alone(commands, MotionAxis.YAW, 1.0, motion);
      return Optional.of("ahead and turning right: " + alone);
    }
    return motion.last() < NO_TURN_RADPS
        ? Optional.empty()
        : Optional.of(
            text(
                "ahead and turning right: a circle of %.3g m radius at %.3g m/s",
                motion.radiusM(), motion.speedMps()));
  }

  /** Sets the actuators that do nothing at rest, such as rudders, so that it turns right most. */
  private void steer(double[] commands) {
    for (int i = 0; i < commands.length; i++) {
      if (!effects.isIdleAtRest(i)) {
        continue;
      }
      commands[i] = FULL.get(0);
      double turning = yawRadPerS(commands);
      commands[i] = FULL.get(1);
      double gain = turning - yawRadPerS(commands);
      boolean steers = Math.abs(gain) > Math.max(NO_TURN_RADPS, STEERS * Math.abs(turning));
      commands[i] = steers ? Math.signum(gain) : 0.0;
    }
  }

  private double yawRadPerS(double[] commands) {
    return OpenLoop.run(effects.vehicle(commands), MotionAxis.SURGE, 1.0).yawRadPerS();
  }

  private static boolean isZero(double[] commands) {
    return Arrays.stream(commands).allMatch(each -> each == 0.0);
  }

  /** Commands that accelerate the vehicle along the axis and, if possible, along no other. */
  private double[] towards(MotionAxis axis, double sign) {
    List<MotionAxis> others = new ArrayList<>(axes());
    Collections.reverse(others); // a turn spoils a straight way most
    if (file.model().isSubmerged()) { // the surface holds others upright
      others.addAll(List.of(MotionAxis.PITCH, MotionAxis.ROLL));
    }
    others.remove(axis);
    return effects.towards(axis, sign, axes(), others);
  }

  private static String text(String pattern, Object... values) {
    return String.format(Locale.ROOT, pattern, values);
  }
}
