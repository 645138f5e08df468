package org.u2sa.estimation.fusion;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.estimation.measurement.SensedQuantity;

/** A hovering multirotor with a wrong barometer, which loses its receiver. */
class KnownOffsetTest {
  private static final double ALTITUDE_M = 21.0;
  private static final double CLAIM_M = 5.0; // of the barometer

  private final Random random = new Random(5);
  private final Measurement m = new Measurement();
  private final ErrorStateFilter filter = new ErrorStateFilter(FilterTuning.of(MotionDomain.AIR));
  private long micros;
  private double climbedM;
  private double climbMps;
  private double goalMps; // of the climb
  private double worstM; // error of the altitude
  private double receiverM = 0.02; // claim of the receiver's altitudes

  private double gauss(double sigma) {
    return sigma * random.nextGaussian();
  }

  /** Climbs at goalMps with a barometer that is off, and with a receiver of 2 cm, or without. */
  private Estimate hover(double untilS, double barometerM, boolean hasReceiver) {
    worstM = 0.0;
    while (micros < untilS * 1e6) {
      micros += 20_000;
      double change = Math.max(-0.01, Math.min(0.01, goalMps - climbMps));
      climbMps += change;
      climbedM += 0.02 * climbMps;
      double altitude = ALTITUDE_M + climbedM;
      double force = -9.8167 + 0.02 - change / 0.02 + gauss(0.05);
      m.begin("IMU", micros);
      m.set(SensedQuantity.TILT, 0, gauss(0.005), 0.01);
      m.set(SensedQuantity.TILT, 1, gauss(0.005), 0.01);
      m.bodyRates(gauss(0.002), gauss(0.002), gauss(0.002), 0.002);
      filter.add(m.specificForce(gauss(0.05), gauss(0.05), force, 0.05));
      if (micros % 100_000 == 0) {
        m.begin("Compass", micros).heading(0.3 + gauss(0.02), 0.02);
        filter.add(m);
        filter.add(
            m.begin("Barometer", micros).altitude(altitude + barometerM + gauss(0.2), CLAIM_M));
      }
      if (hasReceiver && micros % 200_000 == 0) {
        m.begin("GPS", micros).place(57.7 + gauss(1e-7), -43.2 + gauss(1e-7), 0.02, 0.02);
        m.altitude(altitude + gauss(0.2 * receiverM), receiverM);
        filter.add(m.velocity(gauss(0.03), gauss(0.03), -climbMps + gauss(0.03), 0.03));
      }
      Estimate e = filter.at(micros);
      if (e.hasAltitude()) {
        worstM = Math.max(worstM, Math.abs(e.altitudeM() - altitude));
      }
    }
    return filter.at(micros);
  }

  /** For 30 s with a receiver; a wrong pressure is received after 5 s. */
  private void fly(double barometerM) {
    hover(5.0, 0.0, true);
    hover(30.0, barometerM, true);
  }

  private String barometer() {
    return filter.sources().at(micros).get(0).text();
  }

  @ParameterizedTest
  @ValueSource(doubles = {60.0, -60.0, 25.0, 8.0})
  void add_barometerHeardBeforeTheFirstFix_receiverIsBelieved(double offM) {
    hover(20.0, offM, false);
    Estimate e = hover(23.0, offM, true);
    assertThat(Math.abs(e.altitudeM() - ALTITUDE_M)).isLessThan(0.2);
    e = hover(40.0, offM, true);
    assertThat(Math.abs(e.altitudeM() - ALTITUDE_M)).isLessThan(0.1);
    hover(90.0, offM, false);
    assertThat(worstM).isLessThan(2.0);
  }

  @ParameterizedTest
  @ValueSource(doubles = {25.0, -25.0})
  void add_receiverLost_barometerIsUsedWithItsOffset(double offM) {
    fly(offM);
    assertThat(barometer()).startsWith("biased");
    Estimate e = hover(90.0, offM, false);
    assertThat(worstM).isLessThan(2.0);
    assertThat(e.positionSigmaM(2)).isLessThan(3.0);
    assertThat(barometer()).startsWith("used").endsWith(offM > 0.0 ? "by -25.0 m" : "by 25.0 m");
    e = hover(120.0, offM, true);
    assertThat(worstM).isLessThan(2.0);
    assertThat(Math.abs(e.altitudeM() - ALTITUDE_M)).isLessThan(0.1);
    assertThat(barometer()).startsWith("biased").doesNotContain("corrected");
    assertThat(filter.resets()).isZero();
    hover(150.0, offM, false);
    assertThat(worstM).isLessThan(2.0);
  }

  /** Its altitudes are less certain than the barometer claims to be. */
  @ParameterizedTest
  @ValueSource(doubles = {60.0, -60.0})
  void add_poorReceiverLost_barometerIsUsedWithItsOffset(double offM) {
    receiverM = 7.0;
    hover(60.0, offM, true);
    assertThat(barometer()).startsWith("biased");
    hover(75.0, offM, false);
    assertThat(worstM).isLessThan(10.0);
    hover(90.0, offM, true);
    assertThat(worstM).isLessThan(10.0);
    assertThat(filter.resets()).isLessThanOrEqualTo(1);
  }

  /** Within the gate of either, so that no single altitude reveals it. */
  @ParameterizedTest
  @ValueSource(doubles = {17.0, -17.0})
  void add_barometerWithinTheGateForMinutes_receiverIsBelieved(double offM) {
    receiverM = 5.0;
    hover(10.0, offM, true);
    assertThat(barometer()).startsWith("used");
    assertThat(worstM).isGreaterThan(5.0);
    hover(300.0, offM, true);
    assertThat(barometer()).startsWith("biased");
    hover(330.0, offM, true);
    assertThat(worstM).isLessThan(2.0);
    hover(350.0, offM, false);
    assertThat(worstM).isLessThan(4.0);
  }

  @ParameterizedTest
  @ValueSource(doubles = {6.0, -6.0})
  void add_barometerWithinItsClaim_isUsed(double offM) {
    receiverM = 5.0;
    hover(400.0, offM, true);
    assertThat(barometer()).startsWith("used");
  }

  @Test
  void add_barometerStepsBeforeTheLoss_newOffsetIsUsed() {
    hover(15.0, 0.0, true);
    hover(25.0, 25.0, true);
    hover(30.0, -40.0, true);
    hover(90.0, -40.0, false);
    assertThat(worstM).isLessThan(2.0);
  }

  @Test
  void add_climbAfterTheLoss_changesAreFollowedAndSigmaGrows() {
    fly(25.0);
    double before = hover(40.0, 25.0, false).positionSigmaM(2);
    goalMps = 2.0;
    hover(70.0, 25.0, false);
    goalMps = 0.0;
    Estimate e = hover(100.0, 25.0, false);
    assertThat(Math.abs(e.altitudeM() - ALTITUDE_M - 60.0)).isLessThan(2.0);
    assertThat(e.positionSigmaM(2)).isGreaterThan(before + 0.5);
  }

  @Test
  void positionSigmaM_hourAfterTheLoss_isThatOfTheWeather() {
    fly(25.0);
    double sigma = hover(1_830.0, 25.0, false).positionSigmaM(2);
    assertThat(sigma).isBetween(2.4, 4.0);
  }

  @Test
  void add_barometerJumpsAfterTheLoss_isNoticed() {
    fly(25.0);
    hover(60.0, 25.0, false);
    Estimate e = hover(90.0, 65.0, false);
    assertThat(filter.resets()).isEqualTo(1);
    assertThat(e.altitudeM()).isBetween(ALTITUDE_M + 38.0, ALTITUDE_M + 42.0);
    assertThat(e.positionSigmaM(2)).isGreaterThan(4.5);
    e = hover(120.0, 65.0, true);
    assertThat(Math.abs(e.altitudeM() - ALTITUDE_M)).isLessThan(0.1);
  }

  @Test
  void add_pressureCorrectedAfterTheLoss_altitudeStays() {
    fly(25.0);
    hover(60.0, 25.0, false);
    hover(120.0, 0.0, false);
    assertThat(worstM).isLessThan(2.0);
    assertThat(barometer()).startsWith("used").doesNotContain("corrected");
  }

  @Test
  void add_offsetNeverKnown_barometerIsUsedAsItIs() {
    Estimate e = hover(60.0, 25.0, false);
    assertThat(e.altitudeM()).isBetween(ALTITUDE_M + 24.0, ALTITUDE_M + 26.0);
  }
}
