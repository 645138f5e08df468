package org.u2sa.drivers.wind;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.u2sa.device.port.Anemometer;
import org.u2sa.drivers.link.LinkedBench;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.drivers.link.SimulatedBench;
import org.u2sa.drivers.nmea.Nmea;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.device.SensorErrors;
import org.u2sa.sim.device.SimulatedAnemometer;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.testkit.DeviceContract;

/** Every anemometer on a vehicle that lies to the north in a westerly wind of 10 m/s. */
class AnemometerPortTest extends DeviceContract<Anemometer.Wind> {
  private static final VehicleTruth AT_REST =
      new VehicleTruth(
          0.0, Point.ORIGIN, new Attitude(0.0, 0.0, 0.0), Point.ORIGIN, Point.ORIGIN, Point.ORIGIN);

  @Override
  protected List<Bench<Anemometer.Wind>> benches() {
    MemoryLink wire = new MemoryLink();
    return List.of(
        new LinkedBench<>(
            "NMEA",
            wire,
            new NmeaAnemometer(wire),
            250_000,
            line -> line.fromDevice(Nmea.bytes("WIMWV,270.0,R,10.0,M,A"))),
        new SimulatedBench<>(
            "simulated",
            new SimulatedAnemometer(
                new SensorErrors(4.0, 0.1, 0.1, 0.02, 0.0),
                0.01,
                new NoiseStreams(1),
                () -> AT_REST,
                () -> Point.of(10.0, 0.0, 0.0))));
  }

  @Override
  protected void judge(Anemometer.Wind wind) {
    assertThat(wind.speedMps()).isCloseTo(10.0, within(0.5));
    assertThat(wind.fromRad()).as("to the left").isCloseTo(Math.PI / 2.0, within(0.05));
  }
}
