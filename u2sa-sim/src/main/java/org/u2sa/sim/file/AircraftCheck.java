package org.u2sa.sim.file;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.u2sa.messages.frame.Gravity;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.atmosphere.StandardAtmosphere;
import org.u2sa.sim.flight.WingCoefficients;
import org.u2sa.sim.vehicle.SimulatedVehicle;

/** Performance of an aircraft in still air near sea level. */
final class AircraftCheck {
  private static final double HIGH_M = 500.0;
  private static final double SPUN_UP_S = 0.5;
  private static final int HALVINGS = 30;
  private static final double FULL_PERCENT = 100.0;

  private AircraftCheck() {}

  static List<String> lines(VehicleFile file) {
    List<String> lines = new ArrayList<>();
    lines.add(text("%s: mass %.4g kg", file.name(), file.massKg()));
    if (file.model() instanceof MultirotorModel rotors) {
      lines.addAll(hover(file, rotors));
    } else if (file.model() instanceof FixedWingModel plane) {
      lines.add(wing(plane));
    }
    if (file.model() instanceof JsbsimModel jsbsim) {
      jsbsim.aircraft().ignored().forEach(each -> lines.add("ignored: " + each));
    }
    lines.addAll(VehicleCheck.parts(file));
    return lines;
  }

  /** Measured in simulations with all rotors at the same command. */
  private static List<String> hover(VehicleFile file, MultirotorModel model) {
    double most = climbMps2(file, model, 1.0);
    if (most <= 0.0) {
      return List.of(text("cannot lift its weight: sinks with %.3g m/s^2 at full thrust", -most));
    }
    double low = 0.0;
    double high = 1.0;
    for (int i = 0; i < HALVINGS; i++) {
      double middle = (low + high) / 2.0;
      if (climbMps2(file, model, middle) > 0.0) {
        high = middle;
      } else {
        low = middle;
      }
    }
    double ratio = (most + Gravity.STANDARD_MPS2) / Gravity.STANDARD_MPS2;
    return List.of(
        text("hovers with all rotors at %.1f %%", FULL_PERCENT * high),
        text("full thrust: %.2f times its weight, initially climbs with %.3g m/s^2", ratio, most));
  }

  /** Acceleration along the vehicle's up axis, because unequal rotors tilt the vehicle. */
  private static double climbMps2(VehicleFile file, MultirotorModel model, double command) {
    SimulatedVehicle vehicle = file.make(file.emptyWorld(), Point.of(0.0, 0.0, HIGH_M), 0.0, 1);
    model.actuators().forEach(rotor -> vehicle.command(rotor, command));
    vehicle.step(SPUN_UP_S);
    Point up = vehicle.truth().attitude().nedFromFrd().times(Point.of(0.0, 0.0, -1.0));
    Point a = vehicle.truth().acceleration();
    return a.y() * up.x() + a.x() * up.y() - a.z() * up.z();
  }

  private static String wing(FixedWingModel plane) {
    WingCoefficients wing = plane.wing();
    double weight = plane.mass().massKg() * Gravity.STANDARD_MPS2;
    double lift = wing.lift().zero() + wing.lift().alpha() * wing.stallRad();
    double halfStalled = // half of the wing lifts, the other half acts as a plate
        0.5 * (lift + 2.0 * Math.pow(Math.sin(wing.stallRad()), 2) * Math.cos(wing.stallRad()));
    double density = StandardAtmosphere.SEA_LEVEL_DENSITY_KG_PER_M3;
    return text(
        "wing: %.3g kg/m^2; half of it is stalled at %.1f deg, in level flight at %.1f m/s",
        plane.mass().massKg() / wing.areaM2(),
        Math.toDegrees(wing.stallRad()),
        Math.sqrt(2.0 * weight / (density * wing.areaM2() * halfStalled)));
  }

  private static String text(String pattern, Object... values) {
    return String.format(Locale.ROOT, pattern, values);
  }
}
