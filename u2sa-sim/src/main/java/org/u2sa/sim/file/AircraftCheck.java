package org.u2sa.sim.file;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Locale;
import org.u2sa.messages.frame.Gravity;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.flight.LevelFlight;
import org.u2sa.sim.flight.Rotor;
import org.u2sa.sim.performance.MotionAxis;
import org.u2sa.sim.performance.PureMotion;

/** Performance of an aircraft in still air near sea level, computed from its parameters. */
final class AircraftCheck {
  private static final double FULL_PERCENT = 100.0;
  private static final double EQUAL_PERCENT = 0.05;
  private static final double BALANCED = 0.001; // moment by weight and the farthest rotor's arm

  private AircraftCheck() {}

  static List<String> lines(VehicleModel model) {
    List<String> lines = new ArrayList<>();
    if (model instanceof MultirotorModel rotors) {
      lines.addAll(hover(rotors));
    } else if (model instanceof FixedWingModel plane) {
      lines.addAll(wing(plane));
    } else if (model instanceof JsbsimModel jsbsim) {
      jsbsim.aircraft().ignored().forEach(each -> lines.add("ignored: " + each));
    }
    return lines;
  }

  /** With the rotors' most lift that does not turn the aircraft, and a share of it. */
  private static List<String> hover(MultirotorModel model) {
    List<Rotor> rotors = model.rotors();
    double[][][] effects = new double[rotors.size()][][];
    Arrays.setAll(effects, i -> new double[][] {loads(rotors.get(i)), new double[6]});
    int up = MotionAxis.HEAVE.ordinal();
    double[] shares =
        new PureMotion(effects)
            .along(
                up,
                -1.0,
                List.of(
                    MotionAxis.ROLL.ordinal(),
                    MotionAxis.PITCH.ordinal(),
                    MotionAxis.YAW.ordinal(),
                    MotionAxis.SURGE.ordinal(),
                    MotionAxis.SWAY.ordinal()));
    double[] sum = PureMotion.sum(shares, effects);
    double ratio = -sum[up] / (model.mass().massKg() * Gravity.STANDARD_MPS2);
    double reach = rotors.stream().mapToDouble(each -> each.place().distance()).max().orElseThrow();
    double tilting = Math.hypot(sum[MotionAxis.ROLL.ordinal()], sum[MotionAxis.PITCH.ordinal()]);
    List<String> lines = new ArrayList<>();
    if (tilting > BALANCED * -sum[up] * reach) {
      return List.of("cannot hover: its rotors' moments do not balance");
    }
    double climb = (ratio - 1.0) * Gravity.STANDARD_MPS2;
    if (ratio <= 1.0) {
      return List.of(text("cannot lift its weight: sinks with %.3g m/s^2 at full thrust", -climb));
    }
    DoubleSummaryStatistics percent = // thrust grows with the square of the command
        Arrays.stream(shares)
            .filter(share -> share > 0.0)
            .map(share -> FULL_PERCENT * Math.sqrt(share / ratio))
            .summaryStatistics();
    lines.add(
        percent.getCount() == rotors.size() && percent.getMax() - percent.getMin() < EQUAL_PERCENT
            ? text("hovers with all rotors at %.1f %%", percent.getMax())
            : text("hovers with rotors at %.1f to %.1f %%", percent.getMin(), percent.getMax()));
    if (Math.abs(sum[MotionAxis.YAW.ordinal()]) > BALANCED * -sum[up] * reach) {
      lines.add("turns while it hovers: its rotors' torques do not balance");
    }
    lines.add(
        text("full thrust: %.2f times its weight, initially climbs with %.3g m/s^2", ratio, climb));
    return lines;
  }

  /** Force [N] and moment [N m] at full thrust: forward, right, down. */
  private static double[] loads(Rotor rotor) {
    Point force = rotor.axis().times(rotor.fullThrustN());
    double torque = rotor.spin() * rotor.torque() * rotor.maxRadPerS() * rotor.maxRadPerS();
    Point moment = rotor.place().cross(force).plus(rotor.axis().times(torque));
    return new double[] {force.x(), force.y(), force.z(), moment.x(), moment.y(), moment.z()};
  }

  private static List<String> wing(FixedWingModel plane) {
    double mass = plane.mass().massKg();
    return List.of(
        text(
            "wing: %.3g kg/m^2, stalls at %.1f deg",
            mass / plane.wing().areaM2(), Math.toDegrees(LevelFlight.stallRad(plane.wing()))),
        LevelFlight.of(mass, plane.wing(), plane.surfaces(), plane.propeller())
            .map(
                each ->
                    text("level flight: %.3g to %.3g m/s", each.slowestMps(), each.fastestMps()))
            .orElse("no level flight: thrust, lift or elevators do not suffice"));
  }

  private static String text(String pattern, Object... values) {
    return String.format(Locale.ROOT, pattern, values);
  }
}
