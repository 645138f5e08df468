package org.u2sa.sim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import java.util.function.IntToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.marine.BlueRov2;
import org.u2sa.sim.marine.Hull;
import org.u2sa.sim.marine.Vessel;
import org.u2sa.sim.marine.VesselThruster;
import org.u2sa.sim.marine.Waterplane;

class WavesTest {
  private static final double DEEP_K = Math.pow(2.0 * Math.PI / 6.0, 2.0) / 9.80665;

  private static Waves regular(double heightM, double periodS) {
    return Waves.of(Waves.Spectrum.REGULAR, heightM, periodS, Math.PI / 2.0, 0.0, 3L);
  }

  private static double sigma(int samples, IntToDoubleFunction value) {
    double sum = 0.0;
    double squares = 0.0;
    for (int i = 0; i < samples; i++) {
      double each = value.applyAsDouble(i);
      sum += each;
      squares += each * each;
    }
    return Math.sqrt(squares / samples - sum * sum / samples / samples);
  }

  @ParameterizedTest
  @EnumSource(
      value = Waves.Spectrum.class,
      names = {"JONSWAP", "PIERSON_MOSKOWITZ"})
  void elevationM_hours_fourSigmaIsTheSignificantHeight(Waves.Spectrum spectrum) {
    Waves waves = Waves.of(spectrum, 1.5, 6.0, 0.7, 0.2, 11L);

    double significant = 4.0 * sigma(60_000, i -> waves.elevationM(20.0, -7.0, 0.5 * i));

    assertThat(significant).isCloseTo(1.5, within(0.03));
  }

  @Test
  void elevationM_regular_reachesHalfTheHeightAndTravels() {
    Waves waves = regular(1.0, 6.0);
    double length = 2.0 * Math.PI / DEEP_K;

    assertThat(4.0 * sigma(6_000, i -> waves.elevationM(0.0, 0.0, 0.01 * i)))
        .isCloseTo(Math.sqrt(2.0), within(0.01));
    assertThat(waves.elevationM(length / 6.0, 5.0, 8.0))
        .isCloseTo(waves.elevationM(0.0, 0.0, 7.0), within(1e-9));
  }

  @Test
  void headM_deep_decaysByTheWaveNumber() {
    Waves waves = regular(1.0, 6.0);

    assertThat(waves.headM(3.0, 4.0, 10.0, 2.0))
        .isCloseTo(waves.elevationM(3.0, 4.0, 2.0) * Math.exp(-10.0 * DEEP_K), within(1e-9));
  }

  @Test
  void around_smallHull_agreesWithDifferencesOfTheElevation() {
    Waves waves = Waves.of(Waves.Spectrum.JONSWAP, 1.0, 5.0, 2.0, 0.3, 5L);
    Waves.Motion at = waves.around(Point.of(3.0, 8.0, 0.0), 0.0, 0.01, 0.01, 0.4, 12.0);
    double h = 1e-4;

    assertThat(at.elevationM()).isCloseTo(waves.elevationM(3.0, 8.0, 12.0), within(1e-4));
    assertThat(at.slope().x())
        .isCloseTo(
            (waves.elevationM(3.0 + h, 8.0, 12.0) - waves.elevationM(3.0 - h, 8.0, 12.0)) / 2.0 / h,
            within(1e-4));
    assertThat(at.velocity().z())
        .isCloseTo(
            (waves.elevationM(3.0, 8.0, 12.0 + h) - waves.elevationM(3.0, 8.0, 12.0 - h)) / 2.0 / h,
            within(1e-4));
  }

  @Test
  void of_breakingWaves_areRefused() {
    assertThatThrownBy(() -> regular(3.0, 2.0))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("expected at most 0.89 m");
  }

  private static Vessel vessel(Waves waves, boolean floats, double upM) {
    World sea =
        World.at(new Geodetic(9.0, 54.0, 0.0))
            .with(new Water(0.0, CurrentField.uniform(0.0, 0.0), Optional.of(waves)));
    Hull hull =
        new Hull(
            60.0,
            Point.of(8.0, 15.0, 18.0),
            Point.of(5.0, 60.0, 60.0),
            Point.of(4.0, 10.0, 10.0),
            Point.of(50.0, 100.0, 300.0),
            Point.of(60.0, 80.0, 60.0),
            Point.ORIGIN,
            Point.ORIGIN,
            floats ? Point.ORIGIN : Point.of(0.0, 0.0, 0.05),
            Point.ORIGIN,
            floats ? 0.0 : 60.0 * 9.80665,
            floats ? 1.0 : 0.4,
            floats
                ? Optional.of(new Waterplane(6_000.0, 900.0, 1_500.0, 0.0, 0.0, Point.ORIGIN))
                : Optional.empty(),
            Optional.empty(),
            Optional.empty(),
            Point.ORIGIN,
            true);
    VesselThruster stern =
        new VesselThruster(
            "STERN",
            Point.of(-0.5, 0.0, 0.0),
            Point.of(1.0, 0.0, 0.0),
            50.0,
            40.0,
            0.05,
            2.0,
            0.2,
            0.0);
    return new Vessel(
        hull,
        List.of(stern),
        Footprint.rectangle(0.8, 0.8, 0.8, -0.2, 0.3),
        sea,
        Point.of(0.0, 0.0, upM),
        Math.PI / 2.0);
  }

  private static double heave(Vessel vessel) {
    vessel.step(60.0);
    return sigma(
        1_200,
        i -> {
          vessel.step(0.1);
          return vessel.truth().position().z();
        });
  }

  @Test
  void vessel_longWaves_followsSurfaceInHeaveAndPitch() {
    Waves waves = regular(1.0, 8.0);
    Vessel vessel = vessel(waves, true, 0.0);

    assertThat(heave(vessel)).isCloseTo(0.5 / Math.sqrt(2.0), within(0.02));
    double steepest = 0.5 * Math.pow(2.0 * Math.PI / 8.0, 2.0) / 9.80665;
    double most = 0.0;
    for (int i = 0; i < 160; i++) {
      vessel.step(0.1);
      most = Math.max(most, Math.abs(vessel.truth().attitude().theta()));
    }
    assertThat(most).isCloseTo(steepest, within(0.15 * steepest));
  }

  @Test
  void vessel_waves_surgesWithTheWater() {
    Vessel vessel = vessel(regular(1.0, 8.0), true, 0.0);
    vessel.step(60.0);

    double speed =
        sigma(
            1_200,
            i -> {
              vessel.step(0.1);
              return vessel.truth().velocity().x();
            });

    assertThat(speed).isCloseTo(0.5 * 2.0 * Math.PI / 8.0 / Math.sqrt(2.0), within(0.03));
  }

  @Test
  void vessel_submerged_movesByTheOrbitAtItsDepth() {
    double k = Math.pow(2.0 * Math.PI / 8.0, 2.0) / 9.80665;

    double shallow = heave(vessel(regular(1.0, 8.0), false, -3.0));
    double deep = heave(vessel(regular(1.0, 8.0), false, -30.0));

    assertThat(shallow).isCloseTo(0.5 * Math.exp(-3.0 * k) / Math.sqrt(2.0), within(0.05));
    assertThat(deep).isCloseTo(0.5 * Math.exp(-30.0 * k) / Math.sqrt(2.0), within(0.005));
  }

  @Test
  void vessel_currentThatVaries_takesItUpWithoutAJump() {
    CurrentField field =
        CurrentField.grid(
            new double[] {0.0, 1.0, 0.0, 1.0}, new double[] {0.0, 0.0, 0.0, 0.0}, 2, 40.0, 40.0);
    World river =
        World.at(new Geodetic(9.0, 54.0, 0.0)).with(new Water(0.0, field, Optional.empty()));

    assertThat(field.at(0.0, 0.0, 0.0).x()).isCloseTo(0.5, within(1e-9));
    Vessel still = vessel(regular(0.0, 8.0), true, 0.0);
    Vessel boat =
        new Vessel(
            BlueRov2.hull(), List.of(), still.footprint(), river, Point.of(0.0, 0.0, -5.0), 0.0);
    double before = boat.truth().velocity().x();
    for (int i = 0; i < 600; i++) {
      boat.step(0.05);
      assertThat(Math.abs(boat.truth().velocity().x() - before)).isLessThan(0.02);
      before = boat.truth().velocity().x();
    }
    assertThat(before).isCloseTo(1.0, within(0.15));
  }

  @Test
  void at_profile_isLinearBetweenDepths() {
    CurrentField field =
        CurrentField.uniform(1.0, -2.0)
            .withProfile(new double[] {0.0, 10.0, 20.0}, new double[] {1.0, 0.5, 0.0});

    assertThat(field.at(5.0, 5.0, 5.0).x()).isCloseTo(0.75, within(1e-9));
    assertThat(field.at(5.0, 5.0, 15.0).y()).isCloseTo(-0.5, within(1e-9));
    assertThat(field.at(5.0, 5.0, 99.0).x()).isZero();
  }
}
