package org.u2sa.control.cascade;

import java.util.EnumMap;
import java.util.EnumSet;
import java.util.Map;
import java.util.Set;
import java.util.function.Supplier;
import org.u2sa.control.allocation.DegreeOfFreedom;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;

/** Variables of a cascade: six axes, and how the vehicle turns to its direction of travel. */
final class CascadeVariables {
  private record Way(
      @Variable(
              ifAbsentText = "false",
              text = "Whether the vehicle turns towards the navigation point.")
          boolean facesTheWay,
      @Variable(
              unit = "m",
              min = 0,
              max = 1000,
              ifAbsent = 1,
              text = "Minimum distance of a point to turn to; nearer, the heading is kept.")
          double facingDistance,
      @Variable(
              unit = "m/s",
              min = 0.01,
              max = 100,
              ifAbsent = 0.5,
              text = "Speed to a navigation point that sets none.")
          double cruiseSpeed,
      @Variable(
              ifAbsentText = "false",
              text =
                  "Whether the vehicle moves sideways by leaning the lift of its actuators, as multirotors do. SURGE and SWAY then have gains, but no weight.")
          boolean leans,
      @Variable(
              unit = "deg",
              min = 1,
              max = 60,
              ifAbsent = 25,
              text = "Maximum angle from the vertical of a vehicle that leans.")
          double maxLean) {}

  private final Map<DegreeOfFreedom, Supplier<AxisTuning>> axes =
      new EnumMap<>(DegreeOfFreedom.class);
  private final Settings<Way> way;

  CascadeVariables(Configurator variables) {
    for (DegreeOfFreedom axis : DegreeOfFreedom.values()) {
      String prefix = axis.name() + " ";
      if (axis.ordinal() < DegreeOfFreedom.ROLL.ordinal()) {
        Settings<LinearAxis> linear = variables.settings(LinearAxis.class, prefix);
        axes.put(axis, () -> linear.get().tuning());
      } else {
        Settings<AngularAxis> angular = variables.settings(AngularAxis.class, prefix);
        axes.put(axis, () -> angular.get().tuning());
      }
    }
    way = variables.settings(Way.class);
  }

  AxisTuning of(DegreeOfFreedom axis) {
    return axes.get(axis).get();
  }

  boolean facesTheWay() {
    return way.get().facesTheWay();
  }

  double facingDistanceM() {
    return way.get().facingDistance();
  }

  double cruiseMps() {
    return way.get().cruiseSpeed();
  }

  boolean leans() {
    return way.get().leans();
  }

  double maxLeanRad() {
    return Math.toRadians(way.get().maxLean());
  }

  Set<DegreeOfFreedom> controlled() {
    Set<DegreeOfFreedom> controlled = EnumSet.noneOf(DegreeOfFreedom.class);
    for (DegreeOfFreedom axis : DegreeOfFreedom.values()) {
      if (of(axis).isControlled()) {
        controlled.add(axis);
      }
    }
    return controlled;
  }

  double[] weights() {
    double[] weights = new double[DegreeOfFreedom.COUNT];
    for (DegreeOfFreedom axis : DegreeOfFreedom.values()) {
      weights[axis.ordinal()] = of(axis).weight();
    }
    return weights;
  }
}
