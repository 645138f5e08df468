package org.u2sa.sim.aircraft;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import java.util.stream.DoubleStream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.u2sa.sim.atmosphere.Wind;

class Cessna172Properties {
  @Property(tries = 100)
  void step_anyInputsInFlight_givesNumbersFor60Seconds(
      @ForAll long seed,
      @ForAll @DoubleRange(min = 0.0, max = 90.0) double speed,
      @ForAll @DoubleRange(min = -3.1, max = 3.1) double alpha,
      @ForAll @DoubleRange(min = -1.5, max = 1.5) double beta,
      @ForAll @DoubleRange(min = -3.1, max = 3.1) double roll,
      @ForAll @DoubleRange(min = -1.57, max = 1.57) double pitch) {
    FlightStart start =
        new FlightStart(179.999, 60, 3_000, 0, 1.0, speed, alpha, beta, roll, pitch, 2_400, 0.5);
    Wind wind = Wind.turbulent(2.0, 15.0, seed);
    wild(Cessna172.inFlight(start, wind), seed);
  }

  @Property(tries = 50)
  void step_anyInputsOnTheRunway_givesNumbersFor60Seconds(
      @ForAll long seed, @ForAll @DoubleRange(min = 0.0, max = 20.0) double windMps) {
    RunwayStart start = new RunwayStart(0.0, 0.0, 50.0, 1.0);
    wild(Cessna172.onRunway(start, Wind.turbulent(4.0, windMps, seed), true), seed);
  }

  private static void wild(Cessna172 aircraft, long seed) {
    Random pilot = new Random(seed);
    for (int i = 0; i < 120; i++) {
      ControlInputs inputs =
          ControlInputs.limited(
              2.0 * pilot.nextGaussian(),
              2.0 * pilot.nextGaussian(),
              2.0 * pilot.nextGaussian(),
              pilot.nextDouble() * 1.5,
              pilot.nextDouble() * 2.0,
              pilot.nextDouble(),
              pilot.nextDouble(),
              pilot.nextDouble());
      aircraft.step(inputs, 0.5);
      AircraftMotion s = aircraft.state();
      assertThat(
              DoubleStream.of(
                      s.timeS(),
                      s.longitudeDeg(),
                      s.latitudeDeg(),
                      s.altitudeM(),
                      s.heightAboveGroundM(),
                      s.rollRad(),
                      s.pitchRad(),
                      s.headingRad(),
                      s.rollRateRadPerS(),
                      s.pitchRateRadPerS(),
                      s.yawRateRadPerS(),
                      s.velocityNorthMps(),
                      s.velocityEastMps(),
                      s.velocityDownMps(),
                      s.trueAirspeedMps(),
                      s.calibratedAirspeedMps(),
                      s.angleOfAttackRad(),
                      s.sideslipRad(),
                      s.engineRpm(),
                      s.loadFactor())
                  .allMatch(Double::isFinite))
          .as("%s", s)
          .isTrue();
      assertThat(s.longitudeDeg()).isBetween(-180.0, 180.0);
      assertThat(s.headingRad()).isBetween(0.0, 2.0 * Math.PI);
      assertThat(s.trueAirspeedMps()).isLessThan(200.0);
      assertThat(Math.abs(s.rollRateRadPerS())).isLessThan(20.0);
      assertThat(s.engineRpm()).isBetween(0.0, 4_500.0);
    }
  }
}
