package org.u2sa.estimation.fusion;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;

/** Positions against wheels, with and without a compass: which one gives way. */
class ContradictionTest {
  private final Random random = new Random(7);
  private final Measurement m = new Measurement();
  private final ErrorStateFilter filter =
      new ErrorStateFilter(FilterTuning.of(MotionDomain.GROUND));
  private double psi = 0.5;
  private double north;
  private double east;
  private double worst;
  private double wanderNorth;
  private long micros;
  private double gpsSigma = 1.0;
  private double claim = 1.0;
  private double persistS; // of the receiver's error; 0: each is new
  private double reflectionM; // of the receiver's signals
  private boolean hasCompass = true;
  private boolean hasTurnRate = true;
  private boolean wasBiased; // the wheels

  /** At a true speed, with wheels that show another, around a bend now and then. */
  private void drive(double seconds, double speed, double wheels) {
    for (int i = 0; i < seconds * 20; i++) {
      double turn = i / 100 % 2 == 0 ? 0.0 : 0.2 * Math.signum(speed);
      psi += 0.05 * turn;
      north += 0.05 * speed * Math.cos(psi);
      east += 0.05 * speed * Math.sin(psi);
      micros += 50_000;
      if (hasCompass) {
        double measured = Math.IEEEremainder(psi + 0.02 * random.nextGaussian(), 2.0 * Math.PI);
        filter.add(m.begin("Compass", micros).heading(measured, 0.02));
      }
      m.begin("Wheels", micros).forward(wheels + 0.02 * random.nextGaussian(), 0.02);
      filter.add(hasTurnRate ? m.turnRate(turn + 0.01 * random.nextGaussian(), 0.01) : m);
      if (i % 4 == 0) {
        fix();
      }
      look();
    }
  }

  private void fix() {
    double kept = persistS > 0.0 ? Math.exp(-0.2 / persistS) : 0.0;
    double fresh = gpsSigma * Math.sqrt(1.0 - kept * kept);
    wanderNorth = kept * wanderNorth + fresh * random.nextGaussian();
    double wanderEast = gpsSigma * (persistS > 0.0 ? 0.1 : 1.0) * random.nextGaussian();
    Geodetic at =
        SimulatedMotion.HOME.fromNed(
            Point.of(north + wanderNorth + reflectionM, east + wanderEast, 0.0));
    filter.add(m.begin("GPS", micros).place(at.latitudeDeg(), at.longitudeDeg(), claim, claim));
  }

  private double off() {
    Estimate e = filter.at(micros);
    Point said =
        SimulatedMotion.HOME.nedOf(
            new Geodetic(e.longitudeDeg(), e.latitudeDeg(), SimulatedMotion.HOME.altitudeM()));
    return Math.hypot(said.x() - north, said.y() - east);
  }

  private void look() {
    worst = Math.max(worst, filter.at(micros).isOnEarth() ? off() : 0.0);
    wasBiased |= filter.sources().at(micros).toString().contains("Wheels, standing=BIASED");
  }

  private double headingOff() {
    return Math.abs(Math.IEEEremainder(filter.at(micros).psi() - psi, 2.0 * Math.PI));
  }

  @Test
  void add_stuckWithSpinningWheels_positionStaysAndWheelsAreBiased() {
    drive(20.0, 2.0, 2.0);
    worst = 0.0;
    drive(60.0, 0.0, 2.0);
    assertThat(worst).isLessThan(13.0);
    assertThat(off()).isLessThan(2.5);
    assertThat(filter.sources().at(micros).toString()).contains("source=Wheels, standing=BIASED");
    drive(40.0, 2.0, 2.0);
    assertThat(filter.sources().at(micros).toString()).contains("source=Wheels, standing=USED");
    assertThat(off()).isLessThan(2.5);
  }

  /** A second reflection, while the first is refused. */
  @Test
  void add_receiverJumpsTwice_wheelsAreBelievedMeanwhile() {
    gpsSigma = 0.05;
    claim = 0.35;
    drive(60.0, 0.8, 0.8);
    worst = 0.0;
    reflectionM = 1.5;
    drive(0.8, 0.8, 0.8);
    reflectionM = 3.0;
    drive(3.0, 0.8, 0.8);
    assertThat(filter.sources().at(micros).toString()).doesNotContain("standing=BIASED");
    assertThat(worst).isLessThan(0.6);
    assertThat(filter.resets()).isZero();
  }

  /** A receiver whose errors persist may walk away for a while, too: it takes about 8 s to tell. */
  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 5, 8, 13, 21, 34, 55, 89})
  void add_deadEncoder_positionGoesOn(int seed) {
    random.setSeed(seed);
    drive(20.0, 2.0, 2.0);
    worst = 0.0;
    drive(60.0, 2.0, 0.0);
    assertThat(worst).isLessThan(20.0);
    assertThat(off()).isLessThan(3.5);
  }

  /** Its first fixes must not be taken for more accurate than it says. */
  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 5, 8, 13, 21, 34, 55, 89})
  void add_honestReceiverWithoutPersistentErrors_positionStaysWithinItsNoise(int seed) {
    random.setSeed(seed);
    gpsSigma = 0.02;
    claim = 0.02;
    drive(3.0, 1.0, 1.0);
    worst = 0.0;
    drive(20.0, 1.0, 1.0);
    assertThat(worst).isLessThan(0.15);
    assertThat(filter.resets()).isZero();
  }

  @Test
  void add_noCompassButPositionsAndWheels_headingIsFound() {
    hasCompass = false;
    drive(30.0, 1.0, 1.0);
    assertThat(filter.at(micros).hasHeading()).isTrue();
    assertThat(headingOff()).isLessThan(0.3);
  }

  @Test
  void add_noCompassAndStartInReverse_headingIsWhereItLooks() {
    hasCompass = false;
    drive(20.0, -1.5, -1.5);
    drive(60.0, 2.0, 2.0);
    assertThat(headingOff()).isLessThan(0.2);
    assertThat(off()).isLessThan(2.0);
  }

  /** The first heading is a guess of the wrong sign. */
  @Test
  void add_headingGuessedTheWrongWay_isCorrected() {
    hasCompass = false;
    filter.add(m.begin("Guess", 1).heading(psi + Math.PI, 0.2));
    drive(120.0, 2.0, 2.0);
    assertThat(headingOff()).isLessThan(0.2);
    assertThat(off()).isLessThan(2.5);
    assertThat(filter.resets()).isLessThan(10);
  }

  @Test
  void add_claimOfFiveCentimetresIsOffByThreeMetres_errorIsTheReceivers() {
    gpsSigma = 3.0;
    claim = 0.05;
    drive(30.0, 1.0, 1.0);
    worst = 0.0;
    drive(120.0, 1.0, 1.0);
    assertThat(worst).isLessThan(4.0);
  }

  /** The first heading is wrong: positions are refused for it, and show their noise meanwhile. */
  @Test
  void add_noCompassAndNoiseOfTheClaim_positionIsFoundAgain() {
    random.setSeed(105);
    hasCompass = false;
    drive(30.0, 2.0, 2.0);
    worst = 0.0;
    drive(60.0, 2.0, 2.0);
    assertThat(worst).isLessThan(2.0);
  }

  /** The first position may be off by 7 m, and nobody knows better until its noise has shown. */
  @ParameterizedTest
  @CsvSource({"113, 1.0", "113, 2.0", "116, 2.0", "131, 2.0", "133, 2.0"})
  void add_noiseOfManyClaims_claimGivesWayBeforeWheelsAndPosition(long seed, double speed) {
    random.setSeed(seed);
    gpsSigma = 3.0;
    claim = 0.05;
    drive(30.0, speed, speed);
    assertThat(worst).isLessThan(8.0);
    worst = 0.0;
    drive(120.0, speed, speed);
    assertThat(worst).isLessThan(2.0);
    assertThat(wasBiased).isFalse();
    assertThat(filter.resets()).isZero();
  }

  @Test
  void add_claimOfFiveCentimetresWandersByThreeMetres_errorIsTheReceivers() {
    gpsSigma = 3.0;
    claim = 0.05;
    persistS = 60.0;
    drive(200.0, 1.0, 1.0);
    assertThat(worst).isLessThan(9.0);
  }
}
