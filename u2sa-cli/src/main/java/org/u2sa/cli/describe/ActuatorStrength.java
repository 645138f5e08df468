package org.u2sa.cli.describe;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import org.u2sa.cli.describe.VehicleComposition.AnnouncedActuator;
import org.u2sa.control.allocation.Authority;
import org.u2sa.control.allocation.DegreeOfFreedom;
import org.u2sa.control.allocation.Effector;

/** Combined forces and moments per axis of actuators with numeric effects. */
final class ActuatorStrength {
  private static final double LEAST = 1e-6; // [N, N m]: rounding

  private ActuatorStrength() {}

  /** Maximum per axis [N, N m], in the weaker direction, with no demand on the other axes. */
  static Map<DegreeOfFreedom, Double> of(VehicleComposition vehicle) {
    List<Effector> effectors = new ArrayList<>();
    for (AnnouncedActuator each : vehicle.actuators()) {
      Effector.of(each.announcement()).ifPresent(effectors::add);
    }
    Map<DegreeOfFreedom, Double> strength = new EnumMap<>(DegreeOfFreedom.class);
    for (DegreeOfFreedom axis : DegreeOfFreedom.values()) {
      double most = Authority.of(effectors, Set.of(axis)).most().get(axis);
      if (most > LEAST) {
        strength.put(axis, most);
      }
    }
    return strength;
  }

  /** Readable text; empty if no actuator has a numeric effect. */
  static String words(VehicleComposition vehicle) {
    List<String> words = new ArrayList<>();
    of(vehicle)
        .forEach(
            (axis, most) ->
                words.add(String.format(Locale.ROOT, "%s %.1f %s", axis, most, unit(axis))));
    return String.join(", ", words);
  }

  /** Text for forces or moments. */
  static String unit(DegreeOfFreedom axis) {
    return axis.ordinal() < DegreeOfFreedom.ROLL.ordinal() ? "N" : "N m";
  }
}
