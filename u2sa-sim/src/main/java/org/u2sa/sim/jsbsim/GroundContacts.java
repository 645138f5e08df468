package org.u2sa.sim.jsbsim;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.sim.gear.Tyre;
import org.u2sa.sim.gear.Wheel;

/**
 * Contact points as wheels: legs have the file's springs, dampers and friction; tyres are this
 * simulation's, as stiff as their legs. Positions remain relative to the initial centre of gravity.
 */
final class GroundContacts {
  private static final double TYRE_DAMPING_RATIO = 0.7;
  private static final double RELAXATION_M = 0.3;

  /** A wheel with the brake that acts on it: LEFT, RIGHT, CENTER or NONE. */
  private record Contact(Wheel wheel, String brake) {}

  private final List<Contact> contacts = new ArrayList<>();
  private final List<String> ignored = new ArrayList<>();

  /**
   * @param mass mass of the aircraft, with its centre of gravity computed
   */
  GroundContacts(XmlElement file, MassBalance mass) {
    file.refuseUnknownChildren("contact", "description", "documentation");
    for (XmlElement each : file.children("contact")) {
      contacts.add(contact(each, mass));
    }
  }

  private Contact contact(XmlElement file, MassBalance mass) {
    file.refuseUnknownChildren(
        ("location orientation static_friction dynamic_friction rolling_friction "
                + "spring_coeff damping_coeff damping_coeff_rebound max_steer brake_group "
                + "retractable description")
            .split(" "));
    boolean rolls = file.attribute("type").equals("BOGEY");
    for (String name : List.of("orientation", "damping_coeff_rebound")) {
      file.child(name).ifPresent(each -> ignored.add(each.toString()));
    }
    double usual = rolls ? 0.0 : mass.weight();
    double toSi = UnitNumbers.N_PER_LBF / UnitNumbers.M_PER_FT;
    double spring = toSi * UnitNumbers.number(file, "spring_coeff", "LBS/FT", usual);
    double damping = toSi * damping(file, usual);
    double grip = UnitNumbers.number(file, "static_friction", UnitNumbers.PURE, rolls ? 0.0 : 1.0);
    double rolling =
        rolls ? UnitNumbers.number(file, "rolling_friction", UnitNumbers.PURE, 0.0) : grip;
    String brake = file.child("brake_group").map(XmlElement::text).orElse("NONE");
    double brakeGrip = brake.equals("NONE") ? 0.0 : Math.max(0.0, grip - rolling);
    double kg = mass.weight() * UnitNumbers.KG_PER_LB;
    double tyreDamping = TYRE_DAMPING_RATIO * StrictMath.sqrt(spring * kg);
    double steer = rolls ? UnitNumbers.number(file, "max_steer", "DEG", 0.0) : 0.0;
    if (Math.abs(steer) >= 180.0) {
      ignored.add(file + ": castering");
      steer = 0.0;
    }
    double[] place = UnitNumbers.place(file.requiredChild("location"));
    double[] centre = mass.centre();
    try {
      Wheel wheel =
          new Wheel(
              UnitNumbers.M_PER_FT * (centre[0] - place[0]),
              UnitNumbers.M_PER_FT * (place[1] - centre[1]),
              UnitNumbers.M_PER_FT * (centre[2] - place[2]),
              spring,
              damping,
              new Tyre(spring, tyreDamping, grip, rolling, brakeGrip, RELAXATION_M),
              StrictMath.toRadians(steer));
      return new Contact(wheel, brake);
    } catch (IllegalArgumentException e) {
      throw file.error(e.getMessage(), e);
    }
  }

  private static double damping(XmlElement file, double usual) {
    file.child("damping_coeff")
        .filter(each -> each.optionalAttribute("type").orElse("").equals("SQUARE"))
        .ifPresent(
            each -> {
              throw each.error("type \"SQUARE\": expected a damping proportional to the speed");
            });
    return UnitNumbers.number(file, "damping_coeff", "LBS/FT/SEC", usual);
  }

  List<Wheel> wheels() {
    return contacts.stream().map(Contact::wheel).toList();
  }

  List<String> ignored() {
    return ignored;
  }

  boolean hasBrakes() {
    return contacts.stream().anyMatch(each -> !each.brake.equals("NONE"));
  }

  /**
   * Steers and brakes.
   *
   * @param rudder −1…1, right positive
   * @param left brake 0…1
   * @param right brake 0…1
   */
  void set(double rudder, double left, double right) {
    for (Contact each : contacts) {
      double brake =
          switch (each.brake) {
            case "LEFT" -> left;
            case "RIGHT" -> right;
            default -> Math.min(left, right);
          };
      each.wheel.set(rudder, brake);
    }
  }
}
