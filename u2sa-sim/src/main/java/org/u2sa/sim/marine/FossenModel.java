package org.u2sa.sim.marine;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.u2sa.messages.frame.Gravity;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.motion.RungeKutta;
import org.u2sa.sim.vehicle.BodyState;

/**
 * Equations of motion of a vessel in a steady, irrotational current: M ν̇ᵣ + C(νᵣ) νᵣ + D(νᵣ) νᵣ +
 * g(η) = τ (Fossen 2021, equations 10.1 and 10.130–10.136; with a rigid-body C that does not depend
 * on linear velocity, the current is in νᵣ alone). Waves act by their first-order forces; hulls are
 * assumed small compared with the waves.
 *
 * <p>State: {@link BodyState} with the velocity relative to the water; level of each {@link
 * VesselActuator}.
 */
final class FossenModel implements RungeKutta.Motion {
  static final int LEVELS = BodyState.SIZE;

  private final Hull hull;
  private final List<VesselActuator> actuators;
  private final double[] inverse = new double[36]; // of M, by rows
  private final double[] targets; // steady-state level commanded to each actuator
  private double currentNorth;
  private double currentEast;
  private Optional<Sea> sea = Optional.empty();
  private Point push = Point.ORIGIN; // X, Y [N], N [N m]
  private final double surfaceDown; // down coordinate of the water surface [m]
  private final double[] force = new double[6];

  /**
   * Waves around the hull at one time.
   *
   * @param elevationM above the still surface [m]
   * @param rollRad roll of the surface across the hull [rad]
   * @param pitchRad pitch of the surface along the hull [rad]
   * @param orbital velocity of the water in body axes [m/s]
   * @param level horizontal acceleration of the water in body axes [m/s²]
   * @param acceleration of the water in body axes [m/s²]
   */
  record Sea(
      double elevationM,
      double rollRad,
      double pitchRad,
      Point orbital,
      Point level,
      Point acceleration) {}

  FossenModel(
      Hull hull, List<? extends VesselActuator> actuators, Point current, double surfaceDown) {
    this.hull = hull;
    this.actuators = List.copyOf(actuators);
    drift(current);
    this.surfaceDown = surfaceDown;
    targets = new double[actuators.size()];
    DMatrixRMaj mass = new DMatrixRMaj(6, 6);
    double m = hull.massKg();
    Point g = hull.gravityCentre();
    double[][] rows = {
      {m + hull.addedMass().x(), 0, 0, 0, m * g.z(), -m * g.y()},
      {0, m + hull.addedMass().y(), 0, -m * g.z(), 0, m * g.x()},
      {0, 0, m + hull.addedMass().z(), m * g.y(), -m * g.x(), 0},
      {0, -m * g.z(), m * g.y(), hull.inertia().x() + hull.addedInertia().x(), 0, 0},
      {m * g.z(), 0, -m * g.x(), 0, hull.inertia().y() + hull.addedInertia().y(), 0},
      {-m * g.y(), m * g.x(), 0, 0, 0, hull.inertia().z() + hull.addedInertia().z()}
    };
    for (int i = 0; i < 6; i++) {
      for (int j = 0; j < 6; j++) {
        mass.set(i, j, rows[i][j]);
      }
    }
    if (!CommonOps_DDRM.invert(mass)) {
      throw new IllegalArgumentException("the mass matrix of the hull cannot be inverted");
    }
    System.arraycopy(mass.data, 0, inverse, 0, inverse.length);
  }

  /** Sets the velocity of the water: east, north [m/s]. */
  void drift(Point current) {
    currentEast = current.x();
    currentNorth = current.y();
  }

  /** Velocity of the water: east, north [m/s]. */
  Point drift() {
    return Point.of(currentEast, currentNorth, 0.0);
  }

  /** Sets the waves around the hull. */
  void sea(Sea around) {
    sea = Optional.of(around);
  }

  /** Sets the force of wind and fenders: X, Y [N], N [N m]. */
  void push(Point forceAndMoment) {
    push = forceAndMoment;
  }

  int size() {
    return LEVELS + actuators.size();
  }

  /** Sets an actuator command, −1…1. */
  void command(int actuator, double value) {
    targets[actuator] = actuators.get(actuator).level(value);
  }

  /** Gives each actuator the level that it is commanded to. */
  void settle(double[] s) {
    System.arraycopy(targets, 0, s, LEVELS, targets.length);
  }

  /** Thrust of an actuator [N]; empty if it is not a thruster. */
  OptionalDouble thrustN(int actuator, double[] s) {
    return actuators.get(actuator) instanceof VesselThruster
        ? OptionalDouble.of(s[LEVELS + actuator])
        : OptionalDouble.empty();
  }

  /** Electrical power of all actuators [W]; empty if any is unknown. */
  OptionalDouble powerW(double[] s) {
    double sum = 0.0;
    for (int i = 0; i < targets.length; i++) {
      OptionalDouble each = actuators.get(i).powerW(s[LEVELS + i]);
      if (each.isEmpty()) {
        return OptionalDouble.empty();
      }
      sum += each.getAsDouble();
    }
    return OptionalDouble.of(sum);
  }

  @Override
  public void derivatives(double[] s, double[] rate) {
    double u = s[BodyState.VELOCITY];
    double v = s[BodyState.VELOCITY + 1];
    double w = s[BodyState.VELOCITY + 2];
    double p = s[BodyState.RATES];
    double q = s[BodyState.RATES + 1];
    double r = s[BodyState.RATES + 2];
    BodyState.kinematics(s, rate, currentNorth, currentEast);
    if (sea.isPresent()) {
      Point water = sea.get().orbital;
      actuate(s, rate, u - water.x(), v - water.y(), w - water.z());
      drag(u - water.x(), v - water.y(), w - water.z(), p, q, r);
      push(sea.get(), under(s));
    } else {
      actuate(s, rate, u, v, w);
      drag(u, v, w, p, q, r);
    }
    rigidBody(u, v, w, p, q, r);
    addedMass(u, v, w, p, q, r);
    restore(s);
    force[0] += push.x();
    force[1] += push.y();
    force[5] += push.z();
    for (int i = 0; i < 6; i++) {
      double sum = 0.0;
      for (int j = 0; j < 6; j++) {
        sum += inverse[6 * i + j] * force[j];
      }
      rate[BodyState.VELOCITY + i] = sum;
    }
  }

  private void actuate(double[] s, double[] rate, double u, double v, double w) {
    Arrays.fill(force, 0.0);
    for (int i = 0; i < targets.length; i++) {
      VesselActuator actuator = actuators.get(i);
      double level = s[LEVELS + i];
      rate[LEVELS + i] = (targets[i] - level) / actuator.timeConstantS();
      actuator.act(level, u, v, w, force);
    }
  }

  private void drag(double u, double v, double w, double p, double q, double r) {
    Point linear = linearDrag(u, v, w);
    force[0] -= drag(u, linear.x(), hull.squareDrag().x());
    force[1] -= drag(v, linear.y(), hull.squareDrag().y());
    force[2] -= drag(w, linear.z(), hull.squareDrag().z());
    force[3] -= drag(p, hull.angularDrag().x(), hull.squareAngularDrag().x());
    force[4] -= drag(q, hull.angularDrag().y(), hull.squareAngularDrag().y());
    force[5] -= drag(r, hull.angularDrag().z(), hull.squareAngularDrag().z());
    if (hull.crossFlow().isPresent()) {
      hull.crossFlow().get().drag(v, r, force);
    }
    if (hull.lift().isPresent()) {
      hull.lift().get().act(u, v, w, force);
    }
  }

  private Point linearDrag(double u, double v, double w) {
    Point fade = hull.dragFade();
    if (fade.equals(Point.ORIGIN)) {
      return hull.drag();
    }
    double speed = StrictMath.sqrt(u * u + v * v + w * w);
    return Point.of(
        hull.drag().x() * StrictMath.exp(-fade.x() * speed),
        hull.drag().y() * StrictMath.exp(-fade.y() * speed),
        hull.drag().z() * StrictMath.exp(-fade.z() * speed));
  }

  /**
   * First-order wave forces on a hull that is small compared with the waves: Froude-Krylov force of
   * the displaced water, and added mass (Newman 1977, section 2.12). For a floating hull, the
   * waterplane contributes the vertical part.
   */
  private void push(Sea water, double under) {
    boolean floats = hull.waterplane().isPresent();
    double displaced = floats ? hull.massKg() : under * hull.buoyancyN() / Gravity.STANDARD_MPS2;
    Point krylov = floats ? water.level : water.acceleration;
    Point added = hull.addedMass();
    double share = floats ? 1.0 : under;
    force[0] += displaced * krylov.x() + share * added.x() * water.acceleration.x();
    force[1] += displaced * krylov.y() + share * added.y() * water.acceleration.y();
    force[2] += displaced * krylov.z() + share * added.z() * water.acceleration.z();
  }

  private static double drag(double speed, double linear, double square) {
    return (linear + square * StrictMath.abs(speed)) * speed;
  }

  /** C_RB ν = [m ω × (v + ω × r_g)]; [m r_g × (ω × v) + ω × I ω]. */
  private void rigidBody(double u, double v, double w, double p, double q, double r) {
    double m = hull.massKg();
    Point g = hull.gravityCentre();
    double ax = q * g.z() - r * g.y(); // ω × r_g
    double ay = r * g.x() - p * g.z();
    double az = p * g.y() - q * g.x();
    double bx = q * w - r * v; // ω × v
    double by = r * u - p * w;
    double bz = p * v - q * u;
    force[0] -= m * (bx + q * az - r * ay);
    force[1] -= m * (by + r * ax - p * az);
    force[2] -= m * (bz + p * ay - q * ax);
    double ix = hull.inertia().x() * p;
    double iy = hull.inertia().y() * q;
    double iz = hull.inertia().z() * r;
    force[3] -= m * (g.y() * bz - g.z() * by) + q * iz - r * iy;
    force[4] -= m * (g.z() * bx - g.x() * bz) + r * ix - p * iz;
    force[5] -= m * (g.x() * by - g.y() * bx) + p * iy - q * ix;
  }

  /**
   * C_A ν = [ω × A v]; [v × A v + ω × B ω], A and B diagonal; of A only the coupling with roll if
   * the hull has no Munk moment.
   */
  private void addedMass(double u, double v, double w, double p, double q, double r) {
    double x = hull.addedMass().x() * u;
    double y = hull.addedMass().y() * v;
    double z = hull.addedMass().z() * w;
    double k = hull.addedInertia().x() * p;
    double l = hull.addedInertia().y() * q;
    double n = hull.addedInertia().z() * r;
    if (!hull.hasMunkMoment()) {
      force[1] += p * z;
      force[2] -= p * y;
      force[3] -= v * z - w * y + q * n - r * l;
      force[4] -= r * k - p * n;
      force[5] -= p * l - q * k;
      return;
    }
    force[0] -= q * z - r * y;
    force[1] -= r * x - p * z;
    force[2] -= p * y - q * x;
    force[3] -= v * z - w * y + q * n - r * l;
    force[4] -= w * x - u * z + r * k - p * n;
    force[5] -= u * y - v * x + p * l - q * k;
  }

  /** Weight and buoyancy; buoyancy decreases as the hull surfaces. */
  private void restore(double[] s) {
    double w = s[BodyState.QUATERNION];
    double x = s[BodyState.QUATERNION + 1];
    double y = s[BodyState.QUATERNION + 2];
    double z = s[BodyState.QUATERNION + 3];
    double dx = 2 * (x * z - w * y); // down direction in vehicle axes
    double dy = 2 * (y * z + w * x);
    double dz = 1 - 2 * (x * x + y * y);
    if (hull.waterplane().isPresent()) {
      restoreAtSurface(hull.waterplane().get(), sunkM(s), dx, dy, dz);
      return;
    }
    double buoyancy = hull.buoyancyN() * under(s);
    act(hull.gravityCentre(), hull.massKg() * Gravity.STANDARD_MPS2, dx, dy, dz);
    act(hull.buoyancyCentre(), -buoyancy, dx, dy, dz);
  }

  /** Fraction of a submerging hull that is under water. */
  private double under(double[] s) {
    double under = 0.5 + sunkM(s) / hull.heightM();
    return StrictMath.max(0.0, StrictMath.min(1.0, under));
  }

  private double sunkM(double[] s) {
    double still = s[BodyState.NED + 2] - surfaceDown;
    return sea.isPresent() ? still + sea.get().elevationM : still;
  }

  /** G η of a floating hull, with the ballast's weight (Fossen 2021, equations 4.16 and 4.31). */
  private void restoreAtSurface(Waterplane plane, double sunkM, double dx, double dy, double dz) {
    double roll = StrictMath.atan2(dy, dz);
    double pitch = -StrictMath.asin(StrictMath.max(-1.0, StrictMath.min(1.0, dx)));
    if (sea.isPresent()) {
      roll -= sea.get().rollRad;
      pitch -= sea.get().pitchRad;
    }
    double x = plane.centreAheadM();
    force[2] -= plane.heaveNPerM() * (sunkM - x * pitch);
    force[3] -= plane.rollNmPerRad() * roll;
    force[4] -= plane.pitchNmPerRad() * pitch - x * plane.heaveNPerM() * (sunkM - x * pitch);
    act(plane.ballast(), plane.ballastKg() * Gravity.STANDARD_MPS2, dx, dy, dz);
  }

  private void act(Point at, double downN, double dx, double dy, double dz) {
    force[0] += downN * dx;
    force[1] += downN * dy;
    force[2] += downN * dz;
    force[3] += downN * (at.y() * dz - at.z() * dy);
    force[4] += downN * (at.z() * dx - at.x() * dz);
    force[5] += downN * (at.x() * dy - at.y() * dx);
  }
}
