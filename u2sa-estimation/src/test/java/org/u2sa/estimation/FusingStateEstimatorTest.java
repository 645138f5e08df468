package org.u2sa.estimation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.AircraftState;
import org.u2sa.messages.InertialMeasurement;
import org.u2sa.messages.SensorParts;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.frame.UtmGrid;
import org.u2sa.service.U2SAService;
import org.u2sa.testkit.ServiceKit;

/** The service around the filter: messages in, states, local states and remarks out. */
class FusingStateEstimatorTest {
  private static final Geodetic HOME = new Geodetic(-81.0, 29.0, 5.0);
  private static final double SPEED_MPS = 2.0;

  private final ServiceKit kit = new ServiceKit();

  @AfterEach
  void close() {
    kit.close();
  }

  private void sense(StateInformation measured) {
    kit.publish(Channels.SENSED_STATE, measured);
  }

  private StateInformation state() {
    return kit.latest(Channels.STATE).orElseThrow();
  }

  /** On the way east at 2 m/s since 0 s. */
  private Geodetic place() {
    return HOME.fromEnu(Point.of(SPEED_MPS * kit.nowS(), 0.0, 0.0));
  }

  private StateInformation fix(String name) {
    return new StateInformation()
        .sensorName(name)
        .x(place().longitudeDeg())
        .y(place().latitudeDeg())
        .z(5.0)
        .xSigma(0.5)
        .ySigma(0.5)
        .zSigma(0.5);
  }

  private static StateInformation heading() {
    return new StateInformation().sensorName("Compass").psi(Math.PI / 2.0).psiSigma(0.02);
  }

  private void drive(double seconds) {
    for (int i = 1; i <= seconds * 10; i++) {
      kit.advance(0.1);
      sense(heading());
      if (i % 2 == 0) {
        sense(fix("GPS"));
      }
    }
  }

  private double errorM() {
    return place()
        .distanceM(new Geodetic(state().x().getAsDouble(), state().y().getAsDouble(), 0.0));
  }

  private List<String> remarks() {
    return kit.published(Channels.HEALTH).stream()
        .map(HealthReport::remarks)
        .filter(remarks -> !remarks.isEmpty())
        .reduce((a, b) -> b)
        .orElse(List.of());
  }

  @Test
  void callback_fixesAndHeadings_areOneStateWithVelocityAndSigmas() {
    kit.start(FusingStateEstimator::new);
    drive(20.0);

    assertThat(errorM()).isLessThan(0.3);
    assertThat(state().sensorName()).isEqualTo("StateEstimator");
    assertThat(state().referenceFrame()).isEqualTo(ReferenceFrame.GLOBAL);
    assertThat(state().xDot().getAsDouble()).isCloseTo(SPEED_MPS, within(0.2));
    assertThat(state().psi().getAsDouble()).isCloseTo(Math.PI / 2.0, within(0.05));
    // 0.5 m that may persist, and 0.1 s that the fixes may be late at 2 m/s
    assertThat(state().xSigma().getAsDouble()).isBetween(0.4, 0.6);
    assertThat(state().psiSigma().getAsDouble()).isBetween(0.001, 0.02);
    assertThat(state().phi()).as("nothing measures roll").isEmpty();
    assertThat(state().timestamp()).hasValue(kit.clock().micros());
  }

  @Test
  void callback_aircraftSaysMoreThanAnyState_isPassedOnUntilItFallsSilent() {
    kit.start(FusingStateEstimator::new);
    AircraftState airframe = new AircraftState().weightOnWheels(true).heightAboveGround(0.4);
    sense(airframe.sensorName("Aircraft"));
    drive(1.0);

    assertThat(state())
        .isInstanceOfSatisfying(
            AircraftState.class,
            state -> {
              assertThat(state.weightOnWheels()).isTrue();
              assertThat(state.heightAboveGround()).hasValue(0.4);
              assertThat(state.calibratedAirspeed()).isEmpty();
              assertThat(state.sensorName()).isEqualTo("StateEstimator");
              assertThat(state.x()).isPresent();
            });
    drive(2.0);
    assertThat(state()).isNotInstanceOf(AircraftState.class);
  }

  @Test
  void leverArms_sensorThatNeverReports_isNamedInHealth() {
    kit.with("LEVER ARMS", "GPS = 0.2 0 -0.5; Gps = 0.2 0 -0.5").start(FusingStateEstimator::new);
    drive(15.0);

    assertThat(remarks())
        .filteredOn(remark -> remark.contains("LEVER ARMS"))
        .singleElement()
        .asString()
        .endsWith("have not reported: Gps; these have: Compass, GPS");
    assertThat(kit.log("StateEstimator")).filteredOn(l -> l.contains("LEVER ARMS")).hasSize(1);
  }

  @Test
  void leverArms_sensorOfWhichOnlyAPartReports_isHeard() {
    kit.with("LEVER ARMS", "IMU = 0.2 0 -0.5").start(FusingStateEstimator::new);
    sense(new InertialMeasurement().yawRate(0.0).sensorName("IMU" + SensorParts.INERTIAL));
    drive(15.0);

    assertThat(remarks()).noneMatch(remark -> remark.contains("LEVER ARMS"));
  }

  /** Standing with the wind from behind, a pitot tube shows noise. */
  @Test
  void callback_pitotTubeNearItsNoise_isNoEvidenceOfTheWind() {
    kit.with("DOMAIN", "AIR").start(FusingStateEstimator::new);
    for (int i = 0; i < 100; i++) {
      sense(new StateInformation().sensorName("Pitot tube").fluidxDot(1.5).fluidxDotSigma(2.0));
      drive(0.2);
    }
    assertThat(state().fluidxDotSigma().orElseThrow()).isGreaterThan(4.0);

    sense(new StateInformation().sensorName("Pitot tube").fluidxDot(6.0).fluidxDotSigma(0.3));
    drive(0.1);
    assertThat(state().fluidxDotSigma().orElseThrow()).isLessThan(1.0);
    assertThat(state().fluidxDot().orElseThrow()).isCloseTo(6.0, within(1.0));
  }

  /** Nobody measures without error: who says so has said nothing. */
  @Test
  void callback_claimOfNoError_countsAsNoClaim() {
    kit.with("POSITION SIGMA", 4.0).start(FusingStateEstimator::new);
    for (int i = 0; i < 5; i++) {
      kit.advance(0.2);
      sense(heading());
      sense(fix("GPS").xSigma(0.0).ySigma(0.0));
    }
    assertThat(state().xSigma().getAsDouble()).isGreaterThan(1.0);
  }

  @Test
  void start_headingIsTold_isKnownWithoutACompass() {
    kit.with("START PSI", 40.0).with("START PSI SIGMA", 5.0).start(FusingStateEstimator::new);
    kit.advance(0.2);
    sense(fix("GPS"));
    kit.advance(0.2);
    sense(fix("GPS"));

    assertThat(Math.toDegrees(state().psi().orElseThrow())).isCloseTo(40.0, within(5.0));
    assertThat(Math.toDegrees(state().psiSigma().orElseThrow())).isBetween(4.9, 20.0);
  }

  @Test
  void callback_headingOnly_saysNoPositionYet() {
    kit.start(FusingStateEstimator::new);
    sense(heading());

    assertThat(state().x()).isEmpty();
    assertThat(state().psi().getAsDouble()).isCloseTo(Math.PI / 2.0, within(1e-9));
  }

  @Test
  void callback_utmAndBodyFrames_areUnderstood() {
    kit.start(FusingStateEstimator::new);
    ReferenceFrame utm = UtmGrid.frameAt(HOME);
    for (int i = 1; i <= 100; i++) {
      kit.advance(0.1);
      StateInformation grid = fix("Survey").in(utm);
      sense(grid);
      sense(heading());
      sense(
          new StateInformation()
              .sensorName("Encoders")
              .referenceFrame(ReferenceFrame.BODY)
              .xDot(SPEED_MPS)
              .psiDot(0.0)
              .xDotSigma(0.02)
              .psiDotSigma(0.01));
    }

    assertThat(errorM()).isLessThan(0.3);
    assertThat(state().xDot().getAsDouble()).isCloseTo(SPEED_MPS, within(0.1));
    assertThat(remarks()).anyMatch(line -> line.startsWith("Encoders: used"));
  }

  @Test
  void callback_localFrameOnly_isALocalState() {
    kit.start(FusingStateEstimator::new);
    for (int i = 1; i <= 50; i++) {
      kit.advance(0.1);
      sense(
          new StateInformation()
              .sensorName("Beacons")
              .referenceFrame(ReferenceFrame.LOCAL_ENU)
              .x(100.0 + SPEED_MPS * kit.nowS())
              .y(50.0)
              .psi(0.0)
              .xSigma(0.1)
              .ySigma(0.1)
              .psiSigma(0.02));
    }

    assertThat(state().referenceFrame()).isEqualTo(ReferenceFrame.LOCAL_NED);
    assertThat(state().x().getAsDouble()).isCloseTo(50.0, within(0.2));
    assertThat(state().y().getAsDouble()).isCloseTo(110.0, within(0.3));
    assertThat(state().psi().getAsDouble()).isCloseTo(Math.PI / 2.0, within(0.05));
  }

  @Test
  void callback_inertialMeasurements_giveRollAndPitch() {
    kit.with("DOMAIN", "AIR").start(FusingStateEstimator::new);
    for (int i = 1; i <= 1000; i++) {
      kit.advance(0.01);
      InertialMeasurement imu =
          new InertialMeasurement()
              .rollRate(0.0)
              .pitchRate(0.0)
              .yawRate(0.0)
              .specificForceX(9.793 * Math.sin(0.1))
              .specificForceY(0.0)
              .specificForceZ(-9.793 * Math.cos(0.1));
      imu.sensorName("IMU");
      sense(imu);
      if (i % 20 == 0) {
        sense(fix("GPS"));
        sense(heading());
      }
    }

    assertThat(state().theta().getAsDouble()).isCloseTo(0.1, within(0.01));
    assertThat(state().phi().getAsDouble()).isCloseTo(0.0, within(0.01));
    assertThat(state().zDoubleDot().getAsDouble()).isCloseTo(0.0, within(0.3));
    assertThat(errorM()).isLessThan(0.5);
  }

  @Test
  void callback_ratesAndGyroscopesOfOneBiasedSensor_headingStaysRight() {
    kit.with("DOMAIN", "WATER").start(FusingStateEstimator::new);
    double bias = 0.002; // rad/s, a tenth of GYRO BIAS SIGMA
    for (int i = 1; i <= 20_000; i++) {
      kit.advance(0.01);
      InertialMeasurement imu =
          new InertialMeasurement()
              .rollRate(0.0)
              .pitchRate(0.0)
              .yawRate(bias)
              .specificForceX(0.0)
              .specificForceY(0.0)
              .specificForceZ(-9.793);
      imu.sensorName("IMU" + SensorParts.INERTIAL);
      sense(imu);
      sense(
          new StateInformation()
              .sensorName("IMU")
              .phi(0.0)
              .theta(0.0)
              .psi(Math.PI / 2.0)
              .psiSigma(0.035)
              .phiDot(0.0)
              .thetaDot(0.0)
              .psiDot(bias));
      if (i % 20 == 0) {
        sense(fix("GPS"));
        sense(heading());
      }
    }

    assertThat(state().psiDot().getAsDouble()).as("without the bias").isCloseTo(0.0, within(3e-4));
    assertThat(state().psi().getAsDouble()).isCloseTo(Math.PI / 2.0, within(0.01));
  }

  @Test
  void state_onTheGroundWithoutPositionAndSpeedForFiveSeconds_saysNoPositionUntilAFix() {
    kit.with("DOMAIN", "GROUND").with("LOST SIGMA", 1000.0).start(FusingStateEstimator::new);
    drive(20.0);
    for (int i = 0; i < 49; i++) {
      kit.advance(0.1);
      sense(heading());
    }
    assertThat(state().x()).as("4.9 s after the last fix").isPresent();
    for (int i = 0; i < 2; i++) {
      kit.advance(0.1);
      sense(heading());
    }
    assertThat(state().x()).as("5.1 s after").isEmpty();
    assertThat(state().y()).isEmpty();
    assertThat(state().psi()).isPresent();

    sense(fix("GPS"));
    kit.advance(0.1);
    sense(heading());
    assertThat(state().x()).isPresent();
  }

  @Test
  void state_inTheAirWithoutPositionAndSpeed_goesByItsSigma() {
    kit.with("DOMAIN", "AIR").with("LOST SIGMA", 1000.0).start(FusingStateEstimator::new);
    drive(20.0);
    for (int i = 0; i < 100; i++) {
      kit.advance(0.1);
      sense(heading());
    }
    assertThat(state().x()).isPresent();
  }

  @Test
  void localState_positionJumps_staysSmooth() {
    kit.start(FusingStateEstimator::new);
    drive(20.0);
    List<StateInformation> before = kit.published(Channels.LOCAL_STATE);
    double way = before.get(before.size() - 1).y().getAsDouble();
    assertThat(way).as("along the local east").isCloseTo(SPEED_MPS * 20.0, within(3.0));
    for (int i = 0; i < 100; i++) { // 30 m to the north, for good
      kit.advance(0.1);
      sense(heading());
      Geodetic moved = place().fromEnu(Point.of(0.0, 30.0, 0.0));
      sense(fix("GPS").x(moved.longitudeDeg()).y(moved.latitudeDeg()));
    }

    Geodetic moved = place().fromEnu(Point.of(0.0, 30.0, 0.0));
    double apart =
        moved.distanceM(new Geodetic(state().x().getAsDouble(), state().y().getAsDouble(), 0.0));
    assertThat(apart).as("the global estimate followed").isLessThan(2.0);
    List<StateInformation> all = kit.published(Channels.LOCAL_STATE);
    for (int i = 1; i < all.size(); i++) {
      double step =
          Math.hypot(
              all.get(i).x().getAsDouble() - all.get(i - 1).x().getAsDouble(),
              all.get(i).y().getAsDouble() - all.get(i - 1).y().getAsDouble());
      assertThat(step).as("step %d of the local state", i).isLessThan(1.0);
    }
  }

  @Test
  void health_silentSource_isNamed() {
    kit.start(FusingStateEstimator::new);
    drive(10.0);
    for (int i = 0; i < 100; i++) {
      kit.advance(0.1);
      sense(heading());
    }

    assertThat(remarks()).anyMatch(line -> line.startsWith("GPS: silent"));
    assertThat(remarks()).anyMatch(line -> line.startsWith("Compass: used"));
  }

  @Test
  void callback_measurementFromTheFuture_isIgnoredAndReported() {
    kit.start(FusingStateEstimator::new);
    StateInformation measured = heading();
    measured.timestamp(Clock.micros(100.0));
    sense(measured);

    assertThat(kit.published(Channels.STATE)).isEmpty();
    assertThat(kit.latest(Channels.HEALTH).flatMap(HealthReport::lastError).orElse(""))
        .isEqualTo("");
    kit.advance(2.0);
    assertThat(kit.latest(Channels.HEALTH).flatMap(HealthReport::lastError).orElse(""))
        .contains("Compass", "future");
  }

  @Test
  void swap_forAnother_goesOnWithoutABump() {
    U2SAService first = kit.start(FusingStateEstimator::new);
    drive(20.0);
    StateInformation before = state();
    kit.swap(first, FusingStateEstimator::new);
    kit.advance(0.1);
    sense(heading());

    assertThat(errorM()).isLessThan(0.3);
    assertThat(state().xDot().getAsDouble()).isCloseTo(before.xDot().getAsDouble(), within(0.05));
    assertThat(state().xSigma().getAsDouble())
        .isCloseTo(before.xSigma().getAsDouble(), within(0.1));
  }

  @Test
  void restart_inTheSameRun_goesOnFromWhatItRemembered() {
    U2SAService first = kit.start(FusingStateEstimator::new);
    drive(20.0);
    kit.restart(first, FusingStateEstimator::new);
    kit.advance(0.1);
    sense(heading());

    assertThat(state().x()).as("no fix since, but remembered").isPresent();
    assertThat(errorM()).isLessThan(2.0);
    assertThat(kit.latest(Channels.LOCAL_STATE).orElseThrow().y().getAsDouble())
        .isCloseTo(SPEED_MPS * 20.0, within(12.0));
  }

  @Test
  void swap_forPassThroughAndBack_goesOn() {
    U2SAService first = kit.start(FusingStateEstimator::new);
    drive(10.0);
    U2SAService second = kit.swap(first, PassThroughStateEstimator::new);
    drive(1.0);
    kit.swap(second, FusingStateEstimator::new);
    drive(1.0);

    assertThat(errorM()).isLessThan(1.0);
  }

  @Test
  void start_unknownNeededNumber_isRefused() {
    kit.with("NEEDED", "x, why");

    assertThatThrownBy(() -> kit.start(FusingStateEstimator::new))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("NEEDED")
        .hasMessageContaining("why");
  }

  @Test
  void complementary_fixesAndHeadings_areSmoothed() {
    kit.start(ComplementaryStateEstimator::new);
    for (int i = 1; i <= 200; i++) {
      kit.advance(0.1);
      sense(heading());
      sense(
          new StateInformation()
              .sensorName("Encoders")
              .referenceFrame(ReferenceFrame.BODY)
              .xDot(SPEED_MPS));
      if (i % 10 == 0) {
        Geodetic off = place().fromEnu(Point.of(0.0, i % 20 == 0 ? 1.0 : -1.0, 0.0));
        sense(fix("GPS").x(off.longitudeDeg()).y(off.latitudeDeg()));
      }
    }

    assertThat(errorM()).isLessThan(0.7);
    assertThat(state().psi().getAsDouble()).isCloseTo(Math.PI / 2.0, within(1e-6));
  }

  @Test
  void callback_sensorsOfTwoFluids_countsThoseNamedOnly() {
    kit.with("FLUID SENSORS", "Log, Other log").with("DOMAIN", "WATER");
    kit.start(FusingStateEstimator::new);
    for (int i = 0; i < 100; i++) {
      drive(0.2);
      sense(new StateInformation().sensorName("Wind").fluidxDot(8.0).fluidxDotSigma(0.1));
      sense(new StateInformation().sensorName("Log").fluidxDot(1.5).fluidxDotSigma(0.1));
    }

    assertThat(state().fluidxDot().orElseThrow()).isCloseTo(1.5, within(0.1));
  }
}
