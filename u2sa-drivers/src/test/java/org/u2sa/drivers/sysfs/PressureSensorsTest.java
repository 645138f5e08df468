package org.u2sa.drivers.sysfs;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.function.Supplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.device.AirspeedSensor;
import org.u2sa.device.BarometerSensor;
import org.u2sa.device.DepthSensor;
import org.u2sa.device.pressure.PressureAltitude;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.sim.atmosphere.StandardAtmosphere;
import org.u2sa.sim.device.SensorErrors;
import org.u2sa.sim.device.SimulatedBarometer;
import org.u2sa.sim.device.SimulatedDepthGauge;
import org.u2sa.sim.device.SimulatedPitotTube;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.testkit.ServiceKit;

/** The services over pressures: altitude, depth, airspeed. */
class PressureSensorsTest {
  private static final SensorErrors PERFECT = new SensorErrors(20.0, 0.0, 0.0, 0.0, 0.0);

  private final ServiceKit kit = new ServiceKit();

  @AfterEach
  void end() {
    kit.close();
  }

  private StateInformation sensed() {
    return kit.latest(Channels.SENSED_STATE).orElseThrow();
  }

  private void barometer(SensorErrors errors, double qnhPa, double altitudeM) {
    SimulatedBarometer device =
        new SimulatedBarometer(errors, qnhPa, new NoiseStreams(1), () -> altitudeM);
    kit.start(context -> new BarometerSensor(context, device));
    kit.advance(1.0);
  }

  @ParameterizedTest
  @CsvSource({"-300", "0", "1524", "3000", "10900", "15000"})
  void barometer_todaysQnh_isTheAltitude(double altitudeM) {
    kit.with("QNH", 99_500.0).with("ALTITUDE SIGMA", 3.0);
    barometer(PERFECT, 99_500.0, altitudeM);
    assertThat(sensed().z().orElseThrow()).isCloseTo(altitudeM, within(1e-6));
    assertThat(sensed().zSigma()).hasValue(3.0);
    assertThat(sensed().referenceFrame()).isEqualTo(ReferenceFrame.GLOBAL);
    assertThat(sensed().x()).isEmpty();
    assertThat(sensed().sensorName()).isEqualTo("BarometerSensor");
  }

  @Test
  void barometer_lowPressureWithoutQnh_isTooHighByThirtyFeetAHectopascal() {
    barometer(PERFECT, 100_325.0, 100.0);
    // 10 hPa low; 27 feet a hectopascal near the ground
    assertThat(sensed().z().orElseThrow() - 100.0).isCloseTo(270.0 * 0.3048, within(2.0));
    assertThat(sensed().zSigma()).hasValue(100.0);
  }

  @Test
  void barometer_noise_isAsItsErrorsSay() {
    kit.with("QNH", 101_325.0);
    barometer(new SensorErrors(20.0, 0.0, 12.0, 0.0, 0.0), 101_325.0, 0.0);
    kit.advance(20.0);
    double mean =
        kit.published(Channels.SENSED_STATE).stream()
            .mapToDouble(state -> state.z().orElseThrow())
            .average()
            .orElseThrow();
    double variance =
        kit.published(Channels.SENSED_STATE).stream()
            .mapToDouble(state -> Math.pow(state.z().orElseThrow() - mean, 2))
            .average()
            .orElseThrow();
    assertThat(Math.sqrt(variance)).as("12 Pa are 1 m").isBetween(0.85, 1.15);
  }

  @Test
  void barometer_vacuum_isRefusedAndSaid() {
    barometer(PERFECT, 101_325.0, 30_000.0);
    kit.advance(1.0);
    assertThat(kit.published(Channels.SENSED_STATE)).isEmpty();
    assertThat(kit.latest(Channels.HEALTH).flatMap(HealthReport::lastError).orElse(""))
        .startsWith("the barometer reports ")
        .contains("outside 5000.0…120000.0 Pa");
  }

  @ParameterizedTest
  @CsvSource({"0, 101325", "1000, 89874.57", "5000, 54019.9", "11000, 22632.06"})
  void standardAtmosphere_geopotentialAltitude_isThatOfTheTables(double altitudeM, double pascals) {
    assertThat(PressureAltitude.standardM(pascals)).isCloseTo(altitudeM, within(0.05));
    double geometricM = 6_356_766.0 * altitudeM / (6_356_766.0 - altitudeM);
    assertThat(StandardAtmosphere.at(geometricM).pressurePa()).isCloseTo(pascals, within(0.1));
  }

  private void depth(double depthM) {
    SimulatedDepthGauge device =
        new SimulatedDepthGauge(PERFECT, 998.0, new NoiseStreams(1), () -> depthM);
    kit.with("WATER DENSITY", 998.0);
    kit.start(context -> new DepthSensor(context, device));
    kit.advance(1.0);
  }

  @Test
  void depth_mountedAboveTheOrigin_isAnAltitudeBelowTheWater() {
    kit.with("MOUNTED Z", -0.2).with("WATER LEVEL", 400.0).with("DEPTH SIGMA", 0.05);
    depth(10.0);
    assertThat(sensed().referenceFrame()).isEqualTo(ReferenceFrame.GLOBAL);
    assertThat(sensed().z().orElseThrow()).isCloseTo(389.8, within(1e-9));
    assertThat(sensed().zSigma()).hasValue(0.05);
  }

  @ParameterizedTest
  @CsvSource({"LOCAL_NED, 10", "LOCAL_ENU, -10"})
  void depth_localFrames_haveTheirOwnSigns(String frame, double z) {
    kit.with("DEPTH FRAME", frame);
    depth(10.0);
    assertThat(sensed().referenceFrame()).hasToString(frame);
    assertThat(sensed().z().orElseThrow()).isCloseTo(z, within(1e-9));
  }

  private void pitot(double speedMps, double altitudeM) {
    Supplier<VehicleTruth> truth =
        () ->
            new VehicleTruth(
                0.0,
                Point.ORIGIN,
                new Attitude(0.0, 0.0, 0.0),
                Point.of(0.0, speedMps, 0.0),
                Point.ORIGIN,
                Point.ORIGIN);
    SimulatedPitotTube device =
        new SimulatedPitotTube(
            PERFECT,
            new NoiseStreams(1),
            truth,
            () -> Point.ORIGIN,
            () -> altitudeM,
            Double.POSITIVE_INFINITY);
    kit.start(context -> new AirspeedSensor(context, device));
    kit.advance(1.0);
  }

  @ParameterizedTest
  @CsvSource({"0, 0", "15, 0", "60, 3000", "120, 8000"})
  void airspeed_anyAltitude_isTheTrueAirspeed(double speedMps, double altitudeM) {
    pitot(speedMps, altitudeM);
    assertThat(sensed().fluidxDot().orElseThrow()).isCloseTo(speedMps, within(1e-6));
    assertThat(sensed().fluidyDot()).isEmpty();
    assertThat(sensed().xDot()).isEmpty();
  }

  @Test
  void airspeed_sigma_growsTowardsRestButStaysFinite() {
    pitot(50.0, 0.0);
    // 5 Pa / (1.225 · 50)
    assertThat(sensed().fluidxDotSigma().orElseThrow()).isCloseTo(0.0816, within(0.001));
    kit.with("SERVICE NAME", "Other");
    pitot(0.0, 0.0);
    // √(2 · 5 / 1.225) / 2
    assertThat(sensed().fluidxDotSigma().orElseThrow()).isCloseTo(1.429, within(0.01));
  }

  @Test
  void airspeed_deviceWithoutStaticPressure_takesTheStandardAirAtTheStatesAltitude() {
    double highPa = PressureAltitude.pascalsAt(3_000.0, PressureAltitude.SEA_LEVEL_PA);
    double density = highPa / (287.05287 * PressureAltitude.temperatureAt(3_000.0));
    kit.start(
        context -> new AirspeedSensor(context, new ConstantPitotTube(0.5 * density * 20.0 * 20.0)));
    kit.publish(
        Channels.STATE, new StateInformation().referenceFrame(ReferenceFrame.GLOBAL).z(3_000.0));
    kit.advance(0.5);
    assertThat(sensed().fluidxDot().orElseThrow()).isCloseTo(20.0, within(0.05));
  }
}
