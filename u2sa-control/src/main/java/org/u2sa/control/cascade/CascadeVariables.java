package org.u2sa.control.cascade;

import java.util.EnumMap;
import java.util.EnumSet;
import java.util.Map;
import java.util.Set;
import java.util.function.Supplier;
import org.u2sa.control.Pid;
import org.u2sa.control.allocation.DegreeOfFreedom;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;

/** Variables of a cascade: six axes, and turning to the direction of travel. */
final class CascadeVariables {
  /** Variables of the control of motion along one axis of the vehicle. */
  private record Linear(
      @Variable(min = 0, max = 1000, ifAbsent = 0)
          @Description("Weight of the axis when actuators saturate; 0: the axis is not controlled.")
          double weight,
      @Variable(unit = "kg", min = 0.001, max = 1.0e7, ifAbsent = 1)
          @Description("Mass, including added mass in water.")
          double mass,
      @Variable(unit = "1/s", min = 0, max = 100, ifAbsent = 1)
          @Description("Acceleration per velocity error.")
          double gain,
      @Variable(unit = "s", min = 0, max = 1000, ifAbsent = 4)
          @Description("Integral time of the velocity loop; 0: no integral.")
          double integralTime,
      @Variable(unit = "s", min = 0, max = 100, ifAbsent = 0)
          @Description("Derivative time of the velocity loop; 0: no derivative.")
          double derivativeTime,
      @Variable(unit = "1/s", min = 0, max = 10, ifAbsent = 0.3)
          @Description("Velocity per distance to the navigation point.")
          double positionGain,
      @Variable(unit = "m/s", min = 0, max = 100, ifAbsent = 0.5)
          @Description("Maximum speed along the axis.")
          double maxSpeed) {

    AxisTuning tuning() {
      return new AxisTuning(
          weight, mass, Pid.Gains.of(gain, integralTime, derivativeTime), positionGain, maxSpeed);
    }
  }

  /** Variables of the control of rotation about one axis of the vehicle. */
  private record Angular(
      @Variable(min = 0, max = 1000, ifAbsent = 0)
          @Description("Weight of the axis when actuators saturate; 0: the axis is not controlled.")
          double weight,
      @Variable(min = 1.0e-6, max = 1.0e7, ifAbsent = 1)
          @Description("Moment of inertia, including added inertia in water [kg m²].")
          double inertia,
      @Variable(unit = "1/s", min = 0, max = 100, ifAbsent = 2)
          @Description("Angular acceleration per rate error.")
          double gain,
      @Variable(unit = "s", min = 0, max = 1000, ifAbsent = 2)
          @Description("Integral time of the rate loop; 0: no integral.")
          double integralTime,
      @Variable(unit = "s", min = 0, max = 100, ifAbsent = 0)
          @Description("Derivative time of the rate loop; 0: no derivative.")
          double derivativeTime,
      @Variable(unit = "1/s", min = 0, max = 20, ifAbsent = 0.8)
          @Description("Rate per angle error.")
          double angleGain,
      @Variable(unit = "deg/s", min = 0, max = 1000, ifAbsent = 30)
          @Description("Maximum rotation rate.")
          double maxRate) {

    AxisTuning tuning() {
      return new AxisTuning(
          weight,
          inertia,
          Pid.Gains.of(gain, integralTime, derivativeTime),
          angleGain,
          Math.toRadians(maxRate));
    }
  }

  /** Settings for moving to the navigation point. */
  record Way(
      @Variable(ifAbsentText = "false")
          @Description(
              "Whether the vehicle turns towards the navigation point. One that cannot move sideways always does.")
          boolean facesTheWay,
      @Variable(ifAbsentText = "false")
          @Description(
              "With FACES THE WAY: whether the vehicle turns into wind and current so that its course over ground, not its bow, points at the navigation point. For boats that cannot move sideways.")
          boolean countersDrift,
      @Variable(unit = "m", min = 0, max = 1000, ifAbsent = 1)
          @Description(
              "Minimum distance of a point to turn towards; for a nearer one the heading is kept.")
          double facingDistance,
      @Variable(ifAbsentText = "false")
          @Description(
              "Whether a vehicle that holds a position within FACING DISTANCE, without a heading to hold, turns its bow into wind and current.")
          boolean weatherVanes,
      @Variable(unit = "m/s", min = 0.01, max = 100, ifAbsent = 0.5)
          @Description("Speed towards a navigation point that does not specify one.")
          double cruiseSpeed,
      @Variable(ifAbsentText = "false")
          @Description(
              "Whether the vehicle moves sideways by tilting its lift, as multirotors do. SURGE and SWAY then have gains, but no weight.")
          boolean leans,
      @Variable(unit = "deg", min = 1, max = 60, ifAbsent = 25)
          @Description("Maximum tilt of a vehicle that leans.")
          double maxLean) {}

  private final Map<DegreeOfFreedom, Supplier<AxisTuning>> axes =
      new EnumMap<>(DegreeOfFreedom.class);
  private final Settings<Way> way;

  CascadeVariables(Configurator variables) {
    for (DegreeOfFreedom axis : DegreeOfFreedom.values()) {
      String prefix = axis.name() + " ";
      if (axis.ordinal() < DegreeOfFreedom.ROLL.ordinal()) {
        Settings<Linear> linear = variables.settings(Linear.class, prefix);
        axes.put(axis, () -> linear.get().tuning());
      } else {
        Settings<Angular> angular = variables.settings(Angular.class, prefix);
        axes.put(axis, () -> angular.get().tuning());
      }
    }
    way = variables.settings(Way.class);
  }

  AxisTuning of(DegreeOfFreedom axis) {
    return axes.get(axis).get();
  }

  Way way() {
    return way.get();
  }

  boolean leans() {
    return way().leans();
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
