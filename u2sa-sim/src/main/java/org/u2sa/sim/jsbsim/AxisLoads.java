package org.u2sa.sim.jsbsim;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleSupplier;
import org.u2sa.interfaces.xml.XmlElement;

/** Aerodynamic forces and moments: sums of the functions of six axes. */
final class AxisLoads {
  /** Index of each axis and the sign of its positive direction in body or wind axes. */
  private record Axis(int index, double sign, boolean isWind) {}

  private static final Map<String, Axis> AXES =
      Map.ofEntries(
          Map.entry("DRAG", new Axis(0, -1.0, true)),
          Map.entry("SIDE", new Axis(1, 1.0, true)),
          Map.entry("LIFT", new Axis(2, -1.0, true)),
          Map.entry("AXIAL", new Axis(0, -1.0, false)),
          Map.entry("NORMAL", new Axis(2, -1.0, false)),
          Map.entry("X", new Axis(0, 1.0, false)),
          Map.entry("Y", new Axis(1, 1.0, false)),
          Map.entry("Z", new Axis(2, 1.0, false)),
          Map.entry("ROLL", new Axis(3, 1.0, false)),
          Map.entry("PITCH", new Axis(4, 1.0, false)),
          Map.entry("YAW", new Axis(5, 1.0, false)));

  private record Term(Axis axis, DoubleSupplier value) {}

  private final PropertyTree properties;
  private final List<DoubleSupplier> before = new ArrayList<>();
  private final List<Term> terms = new ArrayList<>();
  private final boolean isWind;
  private double hysteresisLow;
  private double hysteresisHigh;
  private final double[] sums = new double[6];
  private final double[] force = new double[3]; // body axes

  AxisLoads(XmlElement file, PropertyTree properties, FunctionReader functions) {
    this.properties = properties;
    file.refuseUnknownChildren(
        "alphalimits hysteresis_limits function axis description documentation".split(" "));
    properties.define("aero/stall-hyst-norm", 0.0);
    properties.define("aero/cl-squared", 0.0);
    file.child("hysteresis_limits")
        .ifPresent(
            each -> {
              double factor = UnitNumbers.factor(each, "RAD");
              hysteresisLow = factor * UnitNumbers.number(each, "min", UnitNumbers.PURE);
              hysteresisHigh = factor * UnitNumbers.number(each, "max", UnitNumbers.PURE);
            });
    file.children("function").forEach(each -> before.add(functions.function(each)));
    for (XmlElement each : file.children("axis")) {
      read(each, functions);
    }
    isWind = terms.stream().anyMatch(each -> each.axis.isWind && each.axis.index != 1);
    terms.stream()
        .filter(each -> each.axis.index != 1 && each.axis.index < 3 && each.axis.isWind != isWind)
        .findFirst()
        .ifPresent(
            each -> {
              throw file.error("mixes LIFT and DRAG with other axes; expected one kind");
            });
  }

  private void read(XmlElement element, FunctionReader functions) {
    Axis axis = AXES.get(element.attribute("name"));
    String frame = element.optionalAttribute("frame").orElse("BODY");
    if (axis == null || !frame.equals("BODY")) {
      throw element.error(
          "axis \""
              + element.attribute("name")
              + "\" in frame \""
              + frame
              + "\": expected one of "
              + String.join(", ", AXES.keySet().stream().sorted().toList())
              + " in the frame BODY");
    }
    element.refuseUnknownChildren("function", "description", "documentation");
    for (XmlElement function : element.children("function")) {
      if (function.optionalAttribute("apply_at_cg").isPresent()) {
        throw function.error("apply_at_cg is not supported; expected forces at the AERORP");
      }
      terms.add(new Term(axis, functions.function(function)));
    }
  }

  /** Call once before each tick. */
  void step(AirFlow flow) {
    if (hysteresisHigh != 0.0 && flow.alpha > hysteresisHigh) {
      properties.set("aero/stall-hyst-norm", 1.0);
    } else if (hysteresisLow != 0.0 && flow.alpha < hysteresisLow) {
      properties.set("aero/stall-hyst-norm", 0.0);
    }
    if (flow.dynamicPressure > 1.0) {
      double down = StrictMath.cos(flow.alpha) * force[2] - StrictMath.sin(flow.alpha) * force[0];
      double lift = down / (flow.dynamicPressure * flow.area());
      properties.set("aero/cl-squared", lift * lift);
    }
  }

  /** Adds force and moment in body axes [lbf, lbf ft]. */
  void load(AirFlow flow, double[] centre, double[] load) {
    Arrays.fill(sums, 0.0);
    for (DoubleSupplier each : before) {
      each.getAsDouble();
    }
    for (Term each : terms) {
      sums[each.axis.index] += each.axis.sign * each.value.getAsDouble();
    }
    if (isWind) { // wind to body axes: Stevens and Lewis, 3rd ed., eq. 2.3-2
      double ca = StrictMath.cos(flow.alpha);
      double sa = StrictMath.sin(flow.alpha);
      double cb = StrictMath.cos(flow.beta);
      double sb = StrictMath.sin(flow.beta);
      force[0] = ca * cb * sums[0] - ca * sb * sums[1] - sa * sums[2];
      force[1] = sb * sums[0] + cb * sums[1];
      force[2] = sa * cb * sums[0] - sa * sb * sums[1] + ca * sums[2];
    } else {
      System.arraycopy(sums, 0, force, 0, 3);
    }
    double[] reference = flow.reference();
    double x = centre[0] - reference[0];
    double y = reference[1] - centre[1];
    double z = centre[2] - reference[2];
    load[0] += force[0];
    load[1] += force[1];
    load[2] += force[2];
    load[3] += sums[3] + y * force[2] - z * force[1];
    load[4] += sums[4] + z * force[0] - x * force[2];
    load[5] += sums[5] + x * force[1] - y * force[0];
  }
}
