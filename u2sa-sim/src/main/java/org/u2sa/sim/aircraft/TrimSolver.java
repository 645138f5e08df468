package org.u2sa.sim.aircraft;

import static org.u2sa.sim.aircraft.FlightDynamics.P;
import static org.u2sa.sim.aircraft.FlightDynamics.Q;
import static org.u2sa.sim.aircraft.FlightDynamics.Q0;
import static org.u2sa.sim.aircraft.FlightDynamics.R;
import static org.u2sa.sim.aircraft.FlightDynamics.VD;
import static org.u2sa.sim.aircraft.FlightDynamics.VE;
import static org.u2sa.sim.aircraft.FlightDynamics.VN;

import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.ejml.dense.row.MatrixFeatures_DDRM;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Gravity;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.atmosphere.StandardAtmosphere;
import org.u2sa.sim.motion.Arguments;
import org.u2sa.sim.motion.BodyAttitude;

/**
 * Finds {@link Trim}s: Newton's method on the six accelerations (Stevens and Lewis, 2nd ed.,
 * section 3.6).
 */
final class TrimSolver {
  private static final int SIZE = 6;
  private static final int ALPHA = 0;
  private static final int BETA = 1;
  private static final int ELEVATOR = 2;
  private static final int AILERON = 3;
  private static final int RUDDER = 4;
  private static final int POWER = 5; // throttle, or flight-path angle if the throttle is given

  private static final int MAX_STEPS = 60;
  private static final double BALANCED = 1e-7; // maximum residual acceleration [m/s², rad/s²]
  private static final double[] LONGEST_MOVE = {0.05, 0.05, 0.2, 0.2, 0.2, 0.1};
  private static final double CLEAR_OF_GROUND_M = 1_000.0;

  private final double altitudeM;
  private final double speedMps;
  private final double rollRad;
  private final double flaps;
  private final FlightDynamics dynamics = new FlightDynamics(new PistonEngine(true));
  private final double[] state = new double[FlightDynamics.SIZE];
  private final double[] rate = new double[FlightDynamics.SIZE];
  private double givenThrottle = Double.NaN;

  TrimSolver(double altitudeM, double speedMps, double rollRad, double flaps) {
    Arguments.requireInside("trim altitude [m]", altitudeM, -500.0, 10_000.0);
    Arguments.requireInside("trim airspeed [m/s]", speedMps, 15.0, 120.0);
    Arguments.requireInside("trim roll [rad]", rollRad, -1.3, 1.3);
    Arguments.requireInside("trim flaps", flaps, 0.0, 1.0);
    this.altitudeM = altitudeM;
    this.speedMps = speedMps;
    this.rollRad = rollRad;
    this.flaps = flaps;
    dynamics.densityKgPerM3 = StandardAtmosphere.at(altitudeM).densityKgPerM3();
    dynamics.groundM = altitudeM - CLEAR_OF_GROUND_M;
    state[FlightDynamics.ALT] = altitudeM;
  }

  Trim level() {
    return solve(new double[] {0.05, 0.0, -0.05, 0.0, 0.0, 0.6});
  }

  Trim atThrottle(double throttle) {
    Arguments.requireInside("trim throttle", throttle, 0.0, 1.0);
    givenThrottle = throttle;
    return solve(new double[] {0.05, 0.0, -0.05, 0.0, 0.0, 0.0});
  }

  private Trim solve(double[] x) {
    double[] f = new double[SIZE];
    double[] moved = new double[SIZE];
    for (int step = 0; step < MAX_STEPS; step++) {
      residual(x, f);
      double worst = 0.0;
      for (double value : f) {
        worst = Math.max(worst, Math.abs(value));
      }
      if (worst < BALANCED) {
        return result(x);
      }
      DMatrixRMaj slopes = new DMatrixRMaj(SIZE, SIZE);
      for (int j = 0; j < SIZE; j++) {
        double old = x[j];
        double h = 1e-6;
        x[j] = old + h;
        residual(x, moved);
        x[j] = old - h;
        double[] other = new double[SIZE];
        residual(x, other);
        x[j] = old;
        for (int i = 0; i < SIZE; i++) {
          slopes.set(i, j, (moved[i] - other[i]) / (2.0 * h));
        }
      }
      if (!move(x, slopes, f)) {
        break;
      }
    }
    throw new IllegalArgumentException(
        "no steady flight at "
            + speedMps
            + " m/s, "
            + altitudeM
            + " m, roll "
            + rollRad
            + " rad, flaps "
            + flaps
            + (Double.isNaN(givenThrottle) ? "" : ", throttle " + givenThrottle)
            + ": too slow, too fast, or not enough power");
  }

  /** Moves x by a Newton step with limited components; false if no step exists. */
  private static boolean move(double[] x, DMatrixRMaj slopes, double[] f) {
    DMatrixRMaj step = new DMatrixRMaj(SIZE, 1);
    if (!CommonOps_DDRM.solve(slopes, DMatrixRMaj.wrap(SIZE, 1, f), step)
        || MatrixFeatures_DDRM.hasUncountable(step)) {
      return false; // a control at its limit has no effect
    }
    double scale = 1.0;
    for (int i = 0; i < SIZE; i++) {
      scale = Math.min(scale, LONGEST_MOVE[i] / Math.abs(step.get(i)));
    }
    for (int i = 0; i < SIZE; i++) {
      x[i] -= scale * step.get(i);
    }
    return true;
  }

  private void residual(double[] x, double[] f) {
    double theta = pitch(x);
    double turn = turnRate();
    double u = speedMps * StrictMath.cos(x[ALPHA]) * StrictMath.cos(x[BETA]);
    double v = speedMps * StrictMath.sin(x[BETA]);
    double w = speedMps * StrictMath.sin(x[ALPHA]) * StrictMath.cos(x[BETA]);
    Point rates = new Attitude(rollRad, theta, 0.0).bodyRates(Point.of(0.0, 0.0, turn));
    double p = rates.x();
    double q = rates.y();
    double r = rates.z();
    BodyAttitude.write(state, Q0, rollRad, theta, 0.0);
    BodyAttitude a = dynamics.attitude;
    a.set(state[Q0], state[Q0 + 1], state[Q0 + 2], state[Q0 + 3]);
    state[VN] = a.north(u, v, w);
    state[VE] = a.east(u, v, w);
    state[VD] = a.down(u, v, w);
    state[P] = p;
    state[Q] = q;
    state[R] = r;
    ControlInputs inputs = controls(x);
    double ratio = dynamics.densityKgPerM3 / StandardAtmosphere.SEA_LEVEL_DENSITY_KG_PER_M3;
    dynamics.aero.set(inputs, flaps);
    dynamics.engine.set(inputs.throttle(), 1.0, ratio, 200.0);
    state[FlightDynamics.SHAFT] = shaftSpeed(u);
    dynamics.derivatives(state, rate);
    f[0] = a.forward(rate[VN], rate[VE], rate[VD]) + r * v - q * w;
    f[1] = a.right(rate[VN], rate[VE], rate[VD]) + p * w - r * u;
    f[2] = a.below(rate[VN], rate[VE], rate[VD]) + q * u - p * v;
    f[3] = rate[P];
    f[4] = rate[Q];
    f[5] = rate[R];
  }

  private ControlInputs controls(double[] x) {
    double throttle = Double.isNaN(givenThrottle) ? x[POWER] : givenThrottle;
    return ControlInputs.limited(
        x[AILERON], x[ELEVATOR], x[RUDDER], throttle, 1.0, flaps, 0.0, 0.0);
  }

  private double flightPath(double[] x) {
    return Double.isNaN(givenThrottle) ? 0.0 : x[POWER];
  }

  private double turnRate() {
    // Coordinated: ψ' = g tan φ / V (McCormick, Aerodynamics, Aeronautics, and Flight Mechanics,
    // section 7)
    return Gravity.STANDARD_MPS2 * StrictMath.tan(rollRad) / speedMps;
  }

  /**
   * Pitch for a flight-path angle: rate-of-climb constraint (Stevens and Lewis, 2nd ed., eq.
   * 3.6-3).
   */
  private double pitch(double[] x) {
    double a = StrictMath.cos(x[ALPHA]) * StrictMath.cos(x[BETA]);
    double b =
        StrictMath.sin(rollRad) * StrictMath.sin(x[BETA])
            + StrictMath.cos(rollRad) * StrictMath.sin(x[ALPHA]) * StrictMath.cos(x[BETA]);
    double climb = StrictMath.sin(flightPath(x));
    double climb2 = climb * climb;
    return StrictMath.atan2(
        a * b + climb * StrictMath.sqrt(Math.max(0.0, a * a - climb2 + b * b)), a * a - climb2);
  }

  /**
   * Equilibrium speed of engine and propeller, by bisection: engine torque falls with speed,
   * propeller torque rises.
   */
  private double shaftSpeed(double axialMps) {
    double low = 30.0;
    double high = 400.0;
    for (int i = 0; i < 60; i++) {
      double middle = 0.5 * (low + high);
      dynamics.propeller.compute(middle, axialMps, dynamics.densityKgPerM3);
      if (dynamics.engine.torqueNm(middle) > dynamics.propeller.torqueNm()) {
        low = middle;
      } else {
        high = middle;
      }
    }
    return 0.5 * (low + high);
  }

  private Trim result(double[] x) {
    double shaft = state[FlightDynamics.SHAFT];
    return new Trim(
        altitudeM,
        speedMps,
        rollRad,
        pitch(x),
        flightPath(x),
        turnRate(),
        x[ALPHA],
        x[BETA],
        controls(x),
        shaft / PistonEngine.RADPERS_PER_RPM,
        dynamics.propeller.torqueNm() * shaft);
  }
}
