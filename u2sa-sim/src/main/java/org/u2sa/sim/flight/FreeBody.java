package org.u2sa.sim.flight;

import java.util.Arrays;
import java.util.List;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.gear.Wheel;
import org.u2sa.sim.motion.BodyAttitude;
import org.u2sa.sim.motion.RungeKutta;
import org.u2sa.sim.vehicle.BodyState;

/**
 * Equations of motion of a rigid body under weight, aerodynamic loads and ground loads: Beard and
 * McLain, Small Unmanned Aircraft, eq. 3.14 to 3.17.
 *
 * <p>State: {@link BodyState} with the velocity over ground; one state of each actuator; the
 * longitudinal and lateral deflection of each wheel's tyre [m].
 */
final class FreeBody implements RungeKutta.Motion {
  static final int ACTUATORS = BodyState.SIZE;

  final BodyAttitude attitude = new BodyAttitude();
  final Air air = new Air();

  private final AirLoads loads;
  private final List<Wheel> wheels;
  private final double gravityMps2;
  private final double[] load = new double[6];
  private final int tyres;

  private MassProperties mass;

  /** Down coordinate of the ground under the body, at the place of {@link #slope} [m]. */
  double groundDown = Double.POSITIVE_INFINITY;

  private double slopeNorth; // of the ground there, uphill positive [1]
  private double slopeEast;
  private double slopeAtN; // that place [m]
  private double slopeAtE;

  FreeBody(MassProperties mass, AirLoads loads, List<Wheel> wheels, double gravityMps2) {
    this.mass = mass;
    this.loads = loads;
    this.wheels = List.copyOf(wheels);
    this.gravityMps2 = gravityMps2;
    tyres = ACTUATORS + loads.actuators().size();
  }

  int size() {
    return tyres + 2 * wheels.size();
  }

  /** Changes the mass, about the same centre of gravity. */
  void weigh(MassProperties now) {
    mass = now;
  }

  /** Sets attitude and motion through the air from a state. */
  void observe(double[] s) {
    attitude.set(
        s[BodyState.QUATERNION],
        s[BodyState.QUATERNION + 1],
        s[BodyState.QUATERNION + 2],
        s[BodyState.QUATERNION + 3]);
    air.u = s[BodyState.VELOCITY] - attitude.forward(air.windN, air.windE, air.windD);
    air.v = s[BodyState.VELOCITY + 1] - attitude.right(air.windN, air.windE, air.windD);
    air.w = s[BodyState.VELOCITY + 2] - attitude.below(air.windN, air.windE, air.windD);
  }

  @Override
  public void derivatives(double[] s, double[] rate) {
    observe(s);
    BodyState.kinematics(s, rate, 0.0, 0.0);
    Arrays.fill(load, 0.0);
    loads.add(s, rate, ACTUATORS, air, load);
    ground(s, rate);
    accelerate(s, rate);
  }

  private void accelerate(double[] s, double[] rate) {
    double u = s[BodyState.VELOCITY];
    double v = s[BodyState.VELOCITY + 1];
    double w = s[BodyState.VELOCITY + 2];
    double p = s[BodyState.RATES];
    double q = s[BodyState.RATES + 1];
    double r = s[BodyState.RATES + 2];
    double m = mass.massKg();
    double g = gravityMps2;
    rate[BodyState.VELOCITY] = r * v - q * w + load[0] / m + g * attitude.forward(0.0, 0.0, 1.0);
    rate[BodyState.VELOCITY + 1] = p * w - r * u + load[1] / m + g * attitude.right(0.0, 0.0, 1.0);
    rate[BodyState.VELOCITY + 2] = q * u - p * v + load[2] / m + g * attitude.below(0.0, 0.0, 1.0);
    Point j = mass.inertia();
    double jxz = mass.productXz();
    double hx = j.x() * p - jxz * r; // angular momentum
    double hy = j.y() * q;
    double hz = j.z() * r - jxz * p;
    double mx = load[3] - (q * hz - r * hy);
    double my = load[4] - (r * hx - p * hz);
    double mz = load[5] - (p * hy - q * hx);
    double gamma = j.x() * j.z() - jxz * jxz;
    rate[BodyState.RATES] = (j.z() * mx + jxz * mz) / gamma;
    rate[BodyState.RATES + 1] = my / j.y();
    rate[BodyState.RATES + 2] = (jxz * mx + j.x() * mz) / gamma;
  }

  /**
   * Sets the slope of the ground, uphill positive [1], at a place [m]. The ground is level around
   * the body, at the height of the slope under it: it rises and falls as the body moves along.
   */
  void slope(double north, double east, double atN, double atE) {
    slopeNorth = north;
    slopeEast = east;
    slopeAtN = atN;
    slopeAtE = atE;
  }

  private void ground(double[] s, double[] rate) {
    double p = s[BodyState.RATES];
    double q = s[BodyState.RATES + 1];
    double r = s[BodyState.RATES + 2];
    double rise =
        slopeNorth * (s[BodyState.NED] - slopeAtN) + slopeEast * (s[BodyState.NED + 1] - slopeAtE);
    double height = groundDown - rise - s[BodyState.NED + 2];
    double bodyU = s[BodyState.VELOCITY];
    double bodyV = s[BodyState.VELOCITY + 1];
    double bodyW = s[BodyState.VELOCITY + 2];
    double riseMps =
        slopeNorth * attitude.north(bodyU, bodyV, bodyW)
            + slopeEast * attitude.east(bodyU, bodyV, bodyW);
    for (int i = 0; i < wheels.size(); i++) {
      Wheel wheel = wheels.get(i);
      double x = wheel.x();
      double y = wheel.y();
      double z = wheel.z();
      double u = s[BodyState.VELOCITY] + q * z - r * y;
      double v = s[BodyState.VELOCITY + 1] + r * x - p * z;
      double w = s[BodyState.VELOCITY + 2] + p * y - q * x;
      int tyre = tyres + 2 * i;
      wheel.compute(
          attitude,
          height - attitude.down(x, y, z),
          attitude.north(u, v, w),
          attitude.east(u, v, w),
          attitude.down(u, v, w) + riseMps,
          s[tyre],
          s[tyre + 1]);
      rate[tyre] = wheel.deflectionAlongRate();
      rate[tyre + 1] = wheel.deflectionAcrossRate(s[tyre + 1]);
      if (wheel.compressionM() > 0.0) {
        double fx = attitude.forward(wheel.forceN(), wheel.forceE(), wheel.forceD());
        double fy = attitude.right(wheel.forceN(), wheel.forceE(), wheel.forceD());
        double fz = attitude.below(wheel.forceN(), wheel.forceE(), wheel.forceD());
        load[0] += fx;
        load[1] += fy;
        load[2] += fz;
        load[3] += y * fz - z * fy;
        load[4] += z * fx - x * fz;
        load[5] += x * fy - y * fx;
      }
    }
  }

  /** Limits the tyres' deflections to what friction can hold; after each step. */
  void boundTyres(double[] s) {
    for (int i = 0; i < wheels.size(); i++) {
      int tyre = tyres + 2 * i;
      s[tyre] = wheels.get(i).boundedAlong(s[tyre]);
      s[tyre + 1] = wheels.get(i).boundedAcross(s[tyre + 1]);
    }
  }

  /** Whether a wheel or skid touches the ground. */
  boolean stands() {
    return wheels.stream().anyMatch(wheel -> wheel.compressionM() > 0.0);
  }
}
