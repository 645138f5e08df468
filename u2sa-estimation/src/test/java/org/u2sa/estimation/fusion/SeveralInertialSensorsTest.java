package org.u2sa.estimation.fusion;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.u2sa.estimation.fusion.SourceReports.Standing;
import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.estimation.measurement.SensedQuantity;
import org.u2sa.estimation.rotation.Quaternions;
import org.u2sa.messages.SensorParts;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;

/** Two and three inertial sensors on one vehicle: the one that lies is left out and named. */
class SeveralInertialSensorsTest {
  private static final int SECONDS = 60;
  private static final int LIES_FROM = 2000; // steps: biases are known by then
  private static final int STEPS = 100 * SECONDS;
  private static final double WRONG_TILT = 0.3; // rad
  private static final double[][] APART = {{0.5, 0.0, 0.0}, {-0.5, 0.5, 0.0}, {0.0, -0.5, 0.5}};

  /** What becomes of an inertial measurement. */
  enum Lie {
    FROZEN {
      @Override
      double rate(double rate, double last, int steps) {
        return last;
      }
    },
    WRONG_SIGN {
      @Override
      double rate(double rate, double last, int steps) {
        return -rate;
      }
    },
    SCALED {
      @Override
      double rate(double rate, double last, int steps) {
        return 2.0 * rate;
      }
    },
    JUMPED {
      @Override
      double rate(double rate, double last, int steps) {
        return rate + 0.3;
      }
    },
    DRIFTING {
      @Override
      double rate(double rate, double last, int steps) {
        return rate + 0.0005 * steps;
      }
    };

    abstract double rate(double rate, double last, int steps);
  }

  /** One flight. */
  private static final class Flight {
    final SimulatedMotion truth;
    final ErrorStateFilter filter =
        new ErrorStateFilter(Tunings.withoutConstraint(MotionDomain.AIR));
    private final Measurement m = new Measurement();
    private final double[][] last = new double[3][3];
    private final double[] rateBefore = new double[3];
    private boolean tellsEulerRates;
    private boolean tellsTilt;
    private boolean isApart;
    private double squares;
    private int samples;

    Flight(long seed) {
      truth = new SimulatedMotion(seed);
    }

    /**
     * Flies with that many inertial sensors.
     *
     * @param liar which of them lies from LIES_FROM on; -1: none
     */
    Flight fly(int sensors, int liar, Lie lie) {
      Lie[] lies = new Lie[3];
      if (liar >= 0) {
        lies[liar] = lie;
      }
      return fly(sensors, lies);
    }

    /**
     * Flies with that many inertial sensors.
     *
     * @param lies of each sensor from LIES_FROM on; null: none
     */
    Flight fly(int sensors, Lie... lies) {
      double[][] bias = new double[3][];
      for (int i = 0; i < 3; i++) {
        bias[i] = truth.biases(0.01, 0.1);
      }
      for (int i = 1; i <= STEPS; i++) {
        System.arraycopy(truth.rate, 0, rateBefore, 0, 3);
        truth.fly(i < 200 ? 0.0 : 1.0, i < 200 ? 0.0 : 0.3);
        for (int k = 0; k < 3; k++) {
          truth.imu(m, inertial(k), bias[k], 0.02, 0.2); // drawn always: one motion for all
          if (lies[k] != null && i >= LIES_FROM) {
            falsify(lies[k], last[k], i - LIES_FROM);
          } else {
            keep(last[k]);
          }
          if (isApart) {
            mount(APART[k]);
          }
          if (k < sensors) {
            filter.add(m);
          }
          if (k < sensors && tellsEulerRates && i % 2 == 0) {
            filter.add(eulerRates(k));
          }
          if (k < sensors && tellsTilt && i % 2 == 0) {
            filter.add(tilt(k, lies[k] != null && i >= LIES_FROM ? WRONG_TILT : 0.0));
          }
        }
        if (i % 20 == 0) {
          filter.add(truth.fix(m, "GPS", 0.5, 0.2, 1.0));
        }
        if (i % 10 == 0) {
          filter.add(truth.compass(m, "Compass", 0.03));
        }
        if (i > LIES_FROM + 1000 && i % 10 == 0) { // ten seconds to see through it
          look();
        }
      }
      return this;
    }

    /** Adds what the sensor feels for being away from the reference point: ω̇ × l + ω × (ω × l). */
    private void mount(double[] at) {
      Point l = Point.of(at[0], at[1], at[2]);
      Point rate = Point.of(truth.rate[0], truth.rate[1], truth.rate[2]);
      double dt = SimulatedMotion.STEP_MICROS * 1e-6;
      Point change =
          Point.of(
              (rate.x() - rateBefore[0]) / dt,
              (rate.y() - rateBefore[1]) / dt,
              (rate.z() - rateBefore[2]) / dt);
      Point felt = cross(change, l).plus(cross(rate, cross(rate, l)));
      double[] more = {felt.x(), felt.y(), felt.z()};
      SensedQuantity force = SensedQuantity.SPECIFIC_FORCE;
      for (int axis = 0; axis < 3; axis++) {
        m.set(force, axis, m.value(force, axis) + more[axis], m.sigma(force, axis));
      }
      m.mounted(at[0], at[1], at[2]);
    }

    private static Point cross(Point a, Point b) {
      return Point.of(
          a.y() * b.z() - a.z() * b.y(),
          a.z() * b.x() - a.x() * b.z(),
          a.x() * b.y() - a.y() * b.x());
    }

    /** What an IMU's own filter makes of the same gyroscopes. */
    private Measurement eulerRates(int sensor) {
      Attitude attitude =
          new Attitude(Quaternions.phi(truth.r), Quaternions.theta(truth.r), truth.psi());
      SensedQuantity rates = SensedQuantity.BODY_RATES;
      Point euler =
          attitude.eulerRates(Point.of(m.value(rates, 0), m.value(rates, 1), m.value(rates, 2)));
      m.begin("IMU " + sensor + " attitude", truth.micros);
      m.set(SensedQuantity.EULER_RATES, 0, euler.x(), 0.05);
      m.set(SensedQuantity.EULER_RATES, 1, euler.y(), 0.05);
      m.set(SensedQuantity.EULER_RATES, 2, euler.z(), 0.05);
      return m;
    }

    /** Roll and pitch from the filter of the same device. */
    private Measurement tilt(int sensor, double error) {
      m.begin("IMU " + sensor, truth.micros);
      m.set(SensedQuantity.TILT, 0, Quaternions.phi(truth.r) + error, 0.02);
      m.set(SensedQuantity.TILT, 1, Quaternions.theta(truth.r), 0.02);
      return m;
    }

    private static String inertial(int sensor) {
      return "IMU " + sensor + SensorParts.INERTIAL;
    }

    private void keep(double[] to) {
      for (int axis = 0; axis < 3; axis++) {
        to[axis] = m.value(SensedQuantity.BODY_RATES, axis);
      }
    }

    private void falsify(Lie lie, double[] kept, int steps) {
      for (int axis = 0; axis < 3; axis++) {
        double rate = lie.rate(m.value(SensedQuantity.BODY_RATES, axis), kept[axis], steps);
        m.set(SensedQuantity.BODY_RATES, axis, rate, 0.02);
      }
    }

    private void look() {
      Estimate e = filter.at(truth.micros);
      double[] errors = truth.errors(e);
      double tilt = e.phi() - Quaternions.phi(truth.r);
      double pitch = e.theta() - Quaternions.theta(truth.r);
      squares += errors[4] * errors[4] + tilt * tilt + pitch * pitch;
      samples++;
    }

    /** RMS error of the attitude [rad]. */
    double attitudeRms() {
      return Math.sqrt(squares / samples);
    }

    Standing standing(int sensor) {
      return filter.sources().at(truth.micros).stream()
          .filter(each -> each.source().equals(inertial(sensor)))
          .findFirst()
          .orElseThrow()
          .standing();
    }
  }

  @ParameterizedTest
  @EnumSource(Lie.class)
  void add_oneOfThreeLies_isOutvotedAndNamed(Lie lie) {
    Flight alone = new Flight(3).fly(1, -1, lie);
    for (int liar = 0; liar < 3; liar++) {
      Flight lied = new Flight(3).fly(3, liar, lie);
      assertThat(lied.attitudeRms()).isLessThan(3.0 * alone.attitudeRms());
      for (int sensor = 0; sensor < 3; sensor++) {
        assertThat(lied.standing(sensor))
            .as("sensor %d, liar %d", sensor, liar)
            .isEqualTo(sensor == liar ? Standing.BIASED : Standing.USED);
      }
    }
  }

  @Test
  void add_threeSoundOnesApart_allAreUsed() {
    Flight alone = new Flight(3).fly(1, new Lie[3]);
    Flight apart = new Flight(3);
    apart.isApart = true;
    apart.fly(3, new Lie[3]);
    assertThat(apart.filter.state().accusedMicros).isZero();
    assertThat(apart.attitudeRms()).isLessThan(1.5 * alone.attitudeRms());
    for (int sensor = 0; sensor < 3; sensor++) {
      assertThat(apart.standing(sensor)).as("sensor %d", sensor).isEqualTo(Standing.USED);
    }
  }

  @Test
  void add_oneOfThreeApartLies_isOutvotedAndNamed() {
    Flight apart = new Flight(3);
    apart.isApart = true;
    apart.fly(3, 0, Lie.JUMPED);
    assertThat(apart.standing(0)).isEqualTo(Standing.BIASED);
    assertThat(apart.standing(1)).isEqualTo(Standing.USED);
    assertThat(apart.standing(2)).isEqualTo(Standing.USED);
  }

  @ParameterizedTest
  @EnumSource(Lie.class)
  void add_secondOfTwoLies_isLeftOutAndNamed(Lie lie) {
    Flight alone = new Flight(3).fly(1, -1, lie);
    Flight lied = new Flight(3).fly(2, 1, lie);
    assertThat(lied.attitudeRms()).isLessThan(1.1 * alone.attitudeRms());
    assertThat(lied.standing(1)).isEqualTo(Standing.BIASED);
    assertThat(lied.standing(0)).isEqualTo(Standing.USED);
  }

  /** The liar's Euler rates contradict the estimate, too; that is no second opinion. */
  @ParameterizedTest
  @EnumSource(Lie.class)
  void add_secondOfTwoLiesTwice_isLeftOutAndNamed(Lie lie) {
    Flight lied = new Flight(3);
    lied.tellsEulerRates = true;
    lied.fly(2, 1, lie);
    assertThat(lied.standing(1)).isEqualTo(Standing.BIASED);
    assertThat(lied.standing(0)).isEqualTo(Standing.USED);
    assertThat(lied.filter.state().accusedMicros).isZero();
  }

  /** The liar's own roll and pitch contradict the estimate, too; nor is that a second opinion. */
  @ParameterizedTest
  @EnumSource(Lie.class)
  void add_secondOfTwoLiesAndTiltsToo_isLeftOutAndNamed(Lie lie) {
    Flight alone = new Flight(3).fly(1, -1, lie);
    Flight lied = new Flight(3);
    lied.tellsTilt = true;
    lied.fly(2, 1, lie);
    assertThat(lied.attitudeRms()).isLessThan(1.1 * alone.attitudeRms());
    assertThat(lied.standing(1)).isEqualTo(Standing.BIASED);
    assertThat(lied.standing(0)).isEqualTo(Standing.USED);
    assertThat(lied.filter.state().accusedMicros).isZero();
  }

  @ParameterizedTest
  @EnumSource(Lie.class)
  void add_firstOfTwoLies_theSecondTakesItsPlace(Lie lie) {
    Flight alone = new Flight(3).fly(1, -1, lie);
    Flight lied = new Flight(3).fly(2, 0, lie);
    assertThat(lied.attitudeRms()).isLessThan(3.0 * alone.attitudeRms());
    assertThat(lied.standing(1)).isEqualTo(Standing.USED);
    assertThat(lied.standing(0)).isEqualTo(Standing.BIASED);
  }

  /** They meet by chance for some samples now and then: that is no majority. */
  @Test
  void add_twoOfThreeLieDifferently_theFirstKeepsItsPlace() {
    Flight alone = new Flight(3).fly(1, new Lie[3]);
    Flight lied = new Flight(3).fly(3, null, Lie.SCALED, Lie.JUMPED);
    assertThat(lied.attitudeRms()).isLessThan(1.1 * alone.attitudeRms());
    assertThat(lied.standing(0)).isEqualTo(Standing.USED);
    assertThat(lied.standing(1)).isEqualTo(Standing.BIASED);
    assertThat(lied.standing(2)).isEqualTo(Standing.BIASED);
  }
}
