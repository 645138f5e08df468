package org.u2sa.sim.jsbsim;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.flight.MassProperties;

/**
 * Empty aircraft, point masses and fuel: total mass, centre of gravity and inertia. Products of
 * inertia with the lateral axis are neglected.
 */
final class MassBalance {
  /** A weight at a structural place [lb, ft]. */
  private record Load(PropertyTree.Property weight, double[] place) {}

  private final List<Load> loads = new ArrayList<>();
  private final double[] base = new double[4]; // about the empty centre of gravity: xx, yy, zz, xz
  private final double[] centre = new double[3]; // structural [ft]
  private double weight;

  /**
   * @param tanks elements {@code tank} of the propulsion
   */
  MassBalance(XmlElement file, List<XmlElement> tanks, PropertyTree properties) {
    file.refuseUnknownChildren(
        "ixx iyy izz ixy ixz iyz emptywt location pointmass description documentation".split(" "));
    file.refuseUnknownAttributes("name", "negated_crossproduct_inertia");
    String[] names = {"ixx", "iyy", "izz", "ixz"};
    for (int i = 0; i < names.length; i++) {
      base[i] =
          i < 3
              ? UnitNumbers.number(file, names[i], "SLUG*FT2")
              : UnitNumbers.number(file, names[i], "SLUG*FT2", 0.0);
    }
    boolean isPlain =
        file.optionalAttribute("negated_crossproduct_inertia").orElse("true").equals("false");
    base[3] *= isPlain ? 1.0 : -1.0; // otherwise the file gives the matrix element
    XmlElement empty =
        file.children("location").stream()
            .filter(each -> each.attribute("name").equals("CG"))
            .findFirst()
            .orElseThrow(() -> file.error("lacks <location name=\"CG\">"));
    double emptyWeight = UnitNumbers.number(file, "emptywt", UnitNumbers.LBS);
    loads.add(
        new Load(
            properties.define("inertia/empty-weight-lbs", emptyWeight), UnitNumbers.place(empty)));
    List<XmlElement> masses = file.children("pointmass");
    for (int i = 0; i < masses.size(); i++) {
      XmlElement each = masses.get(i);
      each.refuseUnknownChildren("weight location form description".split(" "));
      add(
          properties.define(
              "inertia/pointmass-weight-lbs[" + i + "]",
              UnitNumbers.number(each, "weight", UnitNumbers.LBS)),
          each);
    }
    for (int i = 0; i < tanks.size(); i++) {
      add(
          properties.define(
              "propulsion/tank[" + i + "]/contents-lbs",
              UnitNumbers.number(tanks.get(i), "contents", UnitNumbers.LBS, 0.0)),
          tanks.get(i));
    }
  }

  private void add(PropertyTree.Property property, XmlElement element) {
    loads.add(new Load(property, UnitNumbers.place(element.requiredChild("location"))));
  }

  /** Centre of gravity of the last {@link #update}, structural [ft]. */
  double[] centre() {
    return centre;
  }

  /** Weight of the last {@link #update} [lb]. */
  double weight() {
    return weight;
  }

  /**
   * Sums up all masses and inertias.
   *
   * @throws IllegalArgumentException if no body has these values
   */
  MassProperties update() {
    weight = loads.stream().mapToDouble(each -> each.weight.value).sum();
    for (int axis = 0; axis < 3; axis++) {
      int i = axis;
      centre[i] =
          loads.stream().mapToDouble(each -> each.weight.value * each.place[i]).sum() / weight;
    }
    double[] total = base.clone();
    for (Load each : loads) { // parallel axes
      double mass = each.weight.value / UnitNumbers.LB_PER_SLUG;
      double x = centre[0] - each.place[0];
      double y = each.place[1] - centre[1];
      double z = centre[2] - each.place[2];
      total[0] += mass * (y * y + z * z);
      total[1] += mass * (x * x + z * z);
      total[2] += mass * (x * x + y * y);
      total[3] += mass * x * z;
    }
    double si = UnitNumbers.KG_M2_PER_SLUG_FT2;
    return new MassProperties(
        weight * UnitNumbers.KG_PER_LB,
        Point.of(si * total[0], si * total[1], si * total[2]),
        si * total[3]);
  }
}
