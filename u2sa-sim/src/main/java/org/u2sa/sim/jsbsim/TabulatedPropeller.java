package org.u2sa.sim.jsbsim;

import java.util.List;
import java.util.Optional;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.sim.motion.BodyAttitude;

/**
 * A JSBSim propeller: thrust and power coefficients as functions of the advance ratio and, if it
 * varies, the blade angle. The shaft's speed follows from the difference between the engine's and
 * the propeller's power.
 */
final class TabulatedPropeller {
  private static final double PITCH_PER_RPM_S = 1.0; // the governor's rate [deg/s per rpm]
  private static final double OIL_RPM = 200.0; // no oil pressure for the governor below this
  private static final double SLOWEST_RADPS = 0.01;

  private final PropertyTree properties;
  private final String prefix; // prefix of its properties
  private final BodyAttitude mounting = new BodyAttitude();
  private final double[] place; // structural [ft]
  private final double inertia;
  private final double diameter;
  private final double gearRatio;
  private final double minPitch;
  private final double maxPitch;
  private final double minRpm;
  private final double maxRpm;
  private final boolean isConstantSpeed;
  private final double sense;
  private final double gyroscopicSign;
  private final double pFactor;
  private final double thrustFactor;
  private final double powerFactor;
  private final LookupTable thrustTable;
  private final LookupTable powerTable;
  private final Optional<LookupTable> thrustByMach;
  private final Optional<LookupTable> powerByMach;
  private double pitch;
  private double rpm;

  private double requiredCoefficient; // power coefficient, set by load()

  /**
   * @param prefix prefix of the engine's properties
   * @param thruster the aircraft file's element, with place and orientation
   * @param file the propeller's own file
   */
  TabulatedPropeller(PropertyTree properties, String prefix, XmlElement thruster, XmlElement file) {
    this.properties = properties;
    this.prefix = prefix;
    thruster.refuseUnknownAttributes("file", "name");
    thruster.refuseUnknownChildren("location orient sense p_factor".split(" "));
    file.refuseUnknownChildren(
        ("ixx diameter numblades gearratio minpitch maxpitch minrpm maxrpm constspeed "
                + "reversepitch ct_factor cp_factor table description")
            .split(" "));
    place = UnitNumbers.place(thruster.requiredChild("location"));
    double[] turn = new double[3];
    thruster.child("orient").ifPresent(orient -> readOrientation(orient, turn));
    double[] quaternion = new double[4];
    BodyAttitude.write(quaternion, 0, turn[0], turn[1], turn[2]);
    mounting.set(quaternion[0], quaternion[1], quaternion[2], quaternion[3]);
    sense = UnitNumbers.number(thruster, "sense", UnitNumbers.PURE, 1.0) < 0.0 ? -1.0 : 1.0;
    pFactor = UnitNumbers.number(thruster, "p_factor", UnitNumbers.PURE, 0.0);
    boolean isNew =
        file.optionalAttribute("version")
            .map(text -> UnitNumbers.plain(file, text) > 1.0)
            .orElse(false);
    gyroscopicSign = isNew ? -1.0 : 1.0; // files of version 1.0 keep the sign of old releases
    inertia = Math.max(1e-6, UnitNumbers.number(file, "ixx", "SLUG*FT2"));
    diameter = Math.max(0.001, UnitNumbers.number(file, "diameter", UnitNumbers.FT));
    gearRatio = Math.max(0.001, UnitNumbers.number(file, "gearratio", UnitNumbers.PURE, 1.0));
    minPitch = UnitNumbers.number(file, "minpitch", UnitNumbers.PURE, 0.0);
    maxPitch = UnitNumbers.number(file, "maxpitch", UnitNumbers.PURE, 0.0);
    minRpm = UnitNumbers.number(file, "minrpm", UnitNumbers.PURE, 0.0);
    maxRpm = UnitNumbers.number(file, "maxrpm", UnitNumbers.PURE, 0.0);
    isConstantSpeed =
        UnitNumbers.number(file, "constspeed", UnitNumbers.PURE, maxRpm > 0.0 ? 1.0 : 0.0) != 0.0;
    thrustFactor = UnitNumbers.number(file, "ct_factor", UnitNumbers.PURE, 1.0);
    powerFactor = UnitNumbers.number(file, "cp_factor", UnitNumbers.PURE, 1.0);
    thrustTable = table(file, "C_THRUST").orElseThrow(() -> lacks(file, "C_THRUST"));
    powerTable = table(file, "C_POWER").orElseThrow(() -> lacks(file, "C_POWER"));
    thrustByMach = table(file, "CT_MACH");
    powerByMach = table(file, "CP_MACH");
    pitch = properties.define(prefix + "blade-angle", minPitch).value;
  }

  private static void readOrientation(XmlElement orient, double[] turn) {
    double factor = UnitNumbers.factor(orient, "RAD");
    List<String> names = List.of("roll", "pitch", "yaw");
    orient.refuseUnknownChildren(names.toArray(new String[0]));
    for (int i = 0; i < turn.length; i++) {
      turn[i] = factor * UnitNumbers.number(orient, names.get(i), UnitNumbers.PURE, 0.0);
    }
  }

  private static RuntimeException lacks(XmlElement file, String table) {
    return file.error("lacks <table name=\"" + table + "\">");
  }

  private static Optional<LookupTable> table(XmlElement file, String name) {
    return file.children("table").stream()
        .filter(each -> each.attribute("name").equals(name))
        .findFirst()
        .map(LookupTable::read);
  }

  double gearRatio() {
    return gearRatio;
  }

  /** Speed of the engine's shaft [1/min]. */
  double engineRpm() {
    return rpm * gearRatio;
  }

  void spin(double newRpm) {
    rpm = newRpm;
    properties.set(prefix + "propeller-rpm", rpm);
    properties.set(prefix + "engine-rpm", engineRpm());
    properties.set(prefix + "blade-angle", pitch);
  }

  /**
   * Adds force and moment about the centre of gravity in body axes [lbf, lbf ft].
   *
   * @param powerHp engine power at the propeller
   */
  void load(AirFlow flow, double[] gravityCentre, double powerHp, double[] load) {
    double x = gravityCentre[0] - place[0]; // body axes
    double y = place[1] - gravityCentre[1];
    double z = gravityCentre[2] - place[2];
    double atX = flow.u + flow.q * z - flow.r * y;
    double atY = flow.v + flow.r * x - flow.p * z;
    double atZ = flow.w + flow.p * y - flow.q * x;
    double along = mounting.forward(atX, atY, atZ);
    double sideways = mounting.right(atX, atY, atZ);
    double below = mounting.below(atX, atY, atZ);
    double perS = rpm / 60.0;
    double advanceRatio = along / (diameter * (perS > 0.01 ? perS : 1.0));
    double tip = perS * diameter * StrictMath.PI;
    double mach = StrictMath.sqrt(tip * tip + along * along) / flow.soundSpeed;
    double thrustCoefficient =
        thrustFactor
            * thrustTable.at(advanceRatio, pitch)
            * thrustByMach.map(table -> table.at(mach, 0.0)).orElse(1.0);
    double d2 = diameter * diameter;
    double thrust = thrustCoefficient * perS * perS * d2 * d2 * flow.density;
    // momentum theory: McCormick, Aerodynamics, Aeronautics and Flight Mechanics, eq. 6.15
    double disk = 0.25 * d2 * StrictMath.PI;
    double square = along * Math.abs(along) + 2.0 * thrust / (flow.density * disk);
    double induced = 0.5 * (Math.copySign(StrictMath.sqrt(Math.abs(square)), square) - along);
    double across = StrictMath.sqrt(sideways * sideways + below * below);
    if (pFactor > 0.0001 && across > 0.0001) {
      // the blades' uneven load shifts the thrust; p_factor is in inches
      double shift = sense * pFactor / 12.0 * StrictMath.atan2(across, along + induced) / across;
      y += shift * below;
      z -= shift * sideways; // structural z is up
    }
    double omega = perS * 2.0 * StrictMath.PI;
    double torque =
        -sense * powerHp * UnitNumbers.FTLBF_PER_S_PER_HP / Math.max(SLOWEST_RADPS, omega);
    double spin = inertia * omega * sense * gyroscopicSign;
    double axisX = mounting.north(1.0, 0.0, 0.0);
    double axisY = mounting.east(1.0, 0.0, 0.0);
    double axisZ = mounting.down(1.0, 0.0, 0.0);
    double fx = thrust * axisX;
    double fy = thrust * axisY;
    double fz = thrust * axisZ;
    load[0] += fx;
    load[1] += fy;
    load[2] += fz;
    load[3] += y * fz - z * fy + torque * axisX + spin * (flow.q * axisZ - flow.r * axisY);
    load[4] += z * fx - x * fz + torque * axisY + spin * (flow.r * axisX - flow.p * axisZ);
    load[5] += x * fy - y * fx + torque * axisZ + spin * (flow.p * axisY - flow.q * axisX);
    requiredCoefficient =
        powerFactor
            * powerTable.at(advanceRatio, pitch)
            * powerByMach.map(table -> table.at(mach, 0.0)).orElse(1.0);
    properties.set(prefix + "prop-induced-velocity_fps", induced);
    properties.set(prefix + "thrust-coefficient", thrustCoefficient);
    properties.set(prefix + "thrust-lbs", thrust);
    properties.set(prefix + "advance-ratio", advanceRatio);
  }

  /**
   * Advances the shaft's speed and the governor; call after {@link #load}.
   *
   * @param advance lever of a governed propeller, 0…1
   */
  void turn(double powerHp, double density, double advance, double dtS) {
    if (maxPitch > minPitch && isConstantSpeed && rpm > OIL_RPM) {
      double wanted = minRpm + (maxRpm - minRpm) * advance;
      pitch -= PITCH_PER_RPM_S * (wanted - rpm) * dtS;
      pitch = Math.max(minPitch, Math.min(maxPitch, pitch));
    }
    double perS = Math.max(0.01, rpm / 60.0);
    double d2 = diameter * diameter;
    double required = requiredCoefficient * perS * perS * perS * d2 * d2 * diameter * density;
    double omega = rpm / 60.0 * 2.0 * StrictMath.PI;
    double excess = powerHp * UnitNumbers.FTLBF_PER_S_PER_HP - required;
    double torque = excess / (omega > SLOWEST_RADPS ? omega : 1.0);
    spin(Math.max(0.0, rpm + torque / inertia / (2.0 * StrictMath.PI) * dtS * 60.0));
  }
}
