package org.u2sa.estimation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Gravity;
import org.u2sa.messages.frame.Point;
import org.u2sa.testkit.ServiceKit;

/** An aircraft flies east at 20 m/s into 5 m/s of wind, and its pitot tube fails. */
class AirspeedWatchTest {
  private static final Geodetic HOME = new Geodetic(-81.0, 29.0, 100.0);
  private static final double GROUND_MPS = 20.0;
  private static final double AIR_MPS = 25.0;

  private final ServiceKit kit = new ServiceKit();
  private FusingStateEstimator estimator;
  private double altitudeM = 100.0;

  @BeforeEach
  void start() {
    estimator = kit.with("DOMAIN", "AIR").start(FusingStateEstimator::new);
  }

  @AfterEach
  void close() {
    kit.close();
  }

  /**
   * @param airspeed what the pitot tube reads [m/s] after the given seconds of this leg
   */
  private void fly(double seconds, DoubleUnaryOperator airspeed) {
    for (int i = 1; i <= seconds * 10; i++) {
      kit.advance(0.1);
      sense(new StateInformation().sensorName("Compass").psi(Math.PI / 2.0).psiSigma(0.02));
      sense(
          new StateInformation()
              .sensorName("Pitot tube")
              .fluidxDot(airspeed.applyAsDouble(i / 10.0))
              .fluidxDotSigma(0.5));
      if (i % 2 == 0) {
        sense(fix());
      }
    }
  }

  private StateInformation fix() {
    Geodetic place = HOME.fromEnu(Point.of(GROUND_MPS * kit.nowS(), 0.0, 0.0));
    return new StateInformation()
        .sensorName("GPS")
        .x(place.longitudeDeg())
        .y(place.latitudeDeg())
        .z(altitudeM)
        .xSigma(1.0)
        .ySigma(1.0)
        .zSigma(1.0)
        .xDot(GROUND_MPS)
        .yDot(0.0)
        .xDotSigma(0.1)
        .yDotSigma(0.1);
  }

  private void sense(StateInformation measured) {
    kit.publish(Channels.SENSED_STATE, measured);
  }

  private double airspeedMps() {
    return kit.latest(Channels.STATE).orElseThrow().fluidxDot().orElseThrow();
  }

  private String log() {
    return String.join("\n", kit.log("StateEstimator"));
  }

  @Test
  void callback_readingFallsFarBelowGroundSpeedAndWind_isReplacedByThem() {
    fly(60.0, s -> AIR_MPS);
    fly(20.0, s -> Math.max(4.0, AIR_MPS - 2.0 * s)); // as if blocked in a descent

    assertThat(airspeedMps()).isCloseTo(AIR_MPS, within(2.5));
    assertThat(log()).contains("Pitot tube contradicts ground speed and wind by -");
  }

  @Test
  void callback_readingAgreesAgainFor10Seconds_counts() {
    fly(60.0, s -> AIR_MPS);
    fly(10.0, s -> 8.0);
    fly(12.0, s -> AIR_MPS + 2.0);

    assertThat(log()).contains("Pitot tube agrees with ground speed and wind again");
    assertThat(airspeedMps()).isCloseTo(AIR_MPS + 2.0, within(0.7));
  }

  @Test
  void callback_gustsOf4Mps_areBelieved() {
    fly(60.0, s -> AIR_MPS);
    fly(60.0, s -> AIR_MPS + 4.0 * Math.signum(Math.sin(s)));

    assertThat(log()).doesNotContain("contradicts");
    assertThat(Math.abs(airspeedMps() - AIR_MPS)).isGreaterThan(2.0);
  }

  @Test
  void takeOver_readingContradictedBefore_isReplacedByTheSuccessorToo() {
    fly(60.0, s -> AIR_MPS);
    fly(10.0, s -> 8.0);
    kit.swap(estimator, FusingStateEstimator::new);
    fly(10.0, s -> 8.0);

    assertThat(airspeedMps()).isCloseTo(AIR_MPS, within(2.5));
  }

  /**
   * Circles at 25 m/s through the air, 60 s a turn.
   *
   * @param windMps towards the east
   * @param error of the pitot tube [m/s]
   */
  private void circle(double seconds, double windMps, double error) {
    double north = 0.0;
    double east = GROUND_MPS * kit.nowS();
    for (int i = 1; i <= seconds * 10; i++) {
      kit.advance(0.1);
      double psi = Math.PI / 2.0 + i / 10.0 * 2.0 * Math.PI / 60.0;
      double northMps = AIR_MPS * Math.cos(psi);
      double eastMps = AIR_MPS * Math.sin(psi) + windMps;
      north += 0.1 * northMps;
      east += 0.1 * eastMps;
      sense(new StateInformation().sensorName("Compass").psi(psi % (2 * Math.PI)).psiSigma(0.02));
      sense(
          new StateInformation()
              .sensorName("Pitot tube")
              .fluidxDot(AIR_MPS + error)
              .fluidxDotSigma(0.5));
      if (i % 2 == 0) {
        Geodetic place = HOME.fromEnu(Point.of(east, north, 0.0));
        StateInformation fix = fix().x(place.longitudeDeg()).y(place.latitudeDeg());
        sense(fix.xDot(eastMps).yDot(northMps));
      }
    }
  }

  @Test
  void callback_windThatHasChanged_isLearntInTurnsAndTheReadingCountsAgain() {
    fly(60.0, s -> AIR_MPS);
    fly(10.0, s -> AIR_MPS - 10.0); // the headwind has gone: 20 m/s over ground
    assertThat(log()).contains("contradicts");
    circle(120.0, 5.0, 0.0);

    assertThat(log()).contains("Pitot tube agrees with ground speed and wind again");
    assertThat(airspeedMps()).isCloseTo(AIR_MPS, within(1.0));
  }

  @Test
  void callback_readingOffInTurnsToo_staysReplaced() {
    fly(60.0, s -> AIR_MPS);
    fly(10.0, s -> AIR_MPS - 10.0);
    circle(240.0, -5.0, -10.0);

    assertThat(log()).doesNotContain("agrees");
    assertThat(airspeedMps()).isCloseTo(AIR_MPS, within(2.5));
  }

  /**
   * Climbs at a rate [m/s] over ground as before, with the tube blocked at 100 m.
   *
   * @return what the tube reads at the end [m/s]
   */
  private double flyBlocked(double seconds, double climbMps) {
    double fromM = altitudeM;
    fly(
        seconds,
        s -> {
          altitudeM = fromM + climbMps * s;
          return blockedMps();
        });
    return blockedMps();
  }

  private double blockedMps() {
    return Math.sqrt(AIR_MPS * AIR_MPS + 2.0 * Gravity.STANDARD_MPS2 * (altitudeM - 100.0));
  }

  @Test
  void callback_blockedTubeBackAtTheAltitudeOfTheBlock_staysReplaced() {
    fly(60.0, s -> AIR_MPS);
    flyBlocked(10.0, -2.0);
    assertThat(log()).contains("contradicts");
    flyBlocked(10.0, 2.0);
    assertThat(flyBlocked(30.0, 0.0)).isCloseTo(AIR_MPS, within(0.1));
    assertThat(flyBlocked(2.0, -10.0)).isLessThan(16.0);

    assertThat(log()).doesNotContain("agrees");
    assertThat(airspeedMps()).isCloseTo(AIR_MPS, within(1.0));
  }

  @Test
  void callback_tubeBlockedSoonAfterTheStart_isReplacedInTheFirstClimb() {
    fly(4.0, s -> AIR_MPS);
    assertThat(flyBlocked(20.0, 3.0)).isGreaterThan(34.0);

    assertThat(log()).contains("Pitot tube contradicts ground speed and wind by 9 m/s");
    assertThat(airspeedMps()).isCloseTo(AIR_MPS, within(1.0));
  }

  @Test
  void callback_soundTubeInTheFirstClimbIntoMoreWind_counts() {
    fly(
        14.0,
        s -> {
          altitudeM = 100.0 + 3.0 * s;
          return AIR_MPS + 0.5 * s;
        });

    assertThat(log()).doesNotContain("contradicts");
    assertThat(airspeedMps()).isCloseTo(AIR_MPS + 7.0, within(1.0));
  }
}
