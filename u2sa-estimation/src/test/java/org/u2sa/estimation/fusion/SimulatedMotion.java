package org.u2sa.estimation.fusion;

import java.util.Random;
import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.estimation.rotation.Quaternions;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;

/** A true motion from a seed, and what sensors with known errors make of it. */
final class SimulatedMotion {
  static final Geodetic HOME = new Geodetic(-81.0, 29.0, 10.0);
  static final long STEP_MICROS = 10_000;
  private static final double DT = STEP_MICROS * 1e-6;

  final Random random;
  final double[] p = new double[3];
  final double[] v = new double[3];
  final double[] q = {1.0, 0.0, 0.0, 0.0};
  final double[] rate = new double[3];
  final double[] force = new double[3];
  final double[] r = new double[9];
  long micros;
  private final double[] acceleration = new double[3];

  SimulatedMotion(long seed) {
    random = new Random(seed);
    Quaternions.fromEuler(0.0, 0.0, random.nextDouble() * 6.28, q, 0);
  }

  double gauss(double sigma) {
    return sigma * random.nextGaussian();
  }

  /** As the filter's own model without inertial sensors has it: turns, and is pushed at random. */
  void wander(double accelerationNoise, double turnSigma) {
    double sin = Math.sin(rate[2] * DT);
    double cos = Math.cos(rate[2] * DT);
    double vn = v[0];
    double ve = v[1];
    v[0] = cos * vn - sin * ve + gauss(accelerationNoise * Math.sqrt(DT));
    v[1] = sin * vn + cos * ve + gauss(accelerationNoise * Math.sqrt(DT));
    Quaternions.turnBody(q, 0, 0.0, 0.0, rate[2] * DT);
    rate[2] = (1.0 - DT) * rate[2] + gauss(turnSigma * Math.sqrt(2.0 * DT));
    p[0] += DT * (vn + v[0]) / 2.0;
    p[1] += DT * (ve + v[1]) / 2.0;
    micros += STEP_MICROS;
  }

  /** Smooth accelerations and rates in all axes, as of an aircraft; force and rate are means. */
  void fly(double accelerationSigma, double rateSigma) {
    double g = 9.80665;
    Quaternions.matrix(q, 0, r);
    double phi = Quaternions.phi(r);
    double theta = Quaternions.theta(r);
    for (int i = 0; i < 3; i++) {
      acceleration[i] += DT * (-acceleration[i] - 0.05 * v[i]) + gauss(accelerationSigma * 0.1);
      double back = i == 0 ? -phi : i == 1 ? -theta : 0.0;
      rate[i] += DT * (-rate[i] + back) + gauss(rateSigma * 0.1);
    }
    double[] middle = q.clone();
    Quaternions.turnBody(middle, 0, rate[0] * DT / 2, rate[1] * DT / 2, rate[2] * DT / 2);
    Quaternions.matrix(middle, 0, r);
    for (int i = 0; i < 3; i++) {
      force[i] =
          r[i] * acceleration[0] + r[3 + i] * acceleration[1] + r[6 + i] * (acceleration[2] - g);
      p[i] += DT * (v[i] + DT * acceleration[i] / 2.0);
      v[i] += DT * acceleration[i];
    }
    Quaternions.turnBody(q, 0, rate[0] * DT, rate[1] * DT, rate[2] * DT);
    Quaternions.matrix(q, 0, r);
    micros += STEP_MICROS;
  }

  double psi() {
    Quaternions.matrix(q, 0, r);
    return Quaternions.psi(r);
  }

  Geodetic place() {
    return HOME.fromNed(Point.of(p[0], p[1], p[2]));
  }

  /** A satellite fix; errors times {@code lies}, claims as they are. */
  Measurement fix(Measurement m, String name, double sigma, double velocitySigma, double lies) {
    Geodetic at =
        HOME.fromNed(
            Point.of(
                p[0] + gauss(lies * sigma),
                p[1] + gauss(lies * sigma),
                p[2] + gauss(lies * sigma)));
    return m.begin(name, micros)
        .place(at.latitudeDeg(), at.longitudeDeg(), sigma, sigma)
        .altitude(at.altitudeM(), sigma)
        .velocity(
            v[0] + gauss(velocitySigma),
            v[1] + gauss(velocitySigma),
            v[2] + gauss(velocitySigma),
            velocitySigma);
  }

  Measurement compass(Measurement m, String name, double sigma) {
    return m.begin(name, micros).heading(psi() + gauss(sigma), sigma);
  }

  Measurement imu(Measurement m, String name, double[] bias, double rateSigma, double forceSigma) {
    return m.begin(name, micros)
        .bodyRates(
            rate[0] + bias[0] + gauss(rateSigma),
            rate[1] + bias[1] + gauss(rateSigma),
            rate[2] + bias[2] + gauss(rateSigma),
            rateSigma)
        .specificForce(
            force[0] + bias[3] + gauss(forceSigma),
            force[1] + bias[4] + gauss(forceSigma),
            force[2] + bias[5] + gauss(forceSigma),
            forceSigma);
  }

  double[] biases(double gyro, double force) {
    return new double[] {
      gauss(gyro), gauss(gyro), gauss(gyro), gauss(force), gauss(force), gauss(force)
    };
  }

  /** True less estimated: north, east, their velocities, heading. */
  double[] errors(Estimate e) {
    Geodetic here =
        new Geodetic(e.longitudeDeg(), e.latitudeDeg(), e.hasAltitude() ? e.altitudeM() : 10.0);
    Point there = here.nedOf(place());
    return new double[] {
      there.x(),
      there.y(),
      v[0] - e.velocityMps(0),
      v[1] - e.velocityMps(1),
      Math.IEEEremainder(psi() - e.psi(), 2.0 * Math.PI)
    };
  }
}
