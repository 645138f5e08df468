package org.u2sa.drivers.sonar;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.u2sa.device.payload.HydrophoneArray;
import org.u2sa.drivers.link.LinkedBench;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.drivers.link.SimulatedBench;
import org.u2sa.drivers.nmea.Nmea;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.device.SensorErrors;
import org.u2sa.sim.device.SimulatedHydrophones;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.testkit.DeviceContract;

/** Every hydrophone array on a vehicle that points north; the pinger is in the west, 45° below. */
class HydrophonePortTest extends DeviceContract<HydrophoneArray.Heard> {
  private static final VehicleTruth NORTH =
      new VehicleTruth(
          0.0, Point.ORIGIN, new Attitude(0.0, 0.0, 0.0), Point.ORIGIN, Point.ORIGIN, Point.ORIGIN);

  @Override
  protected List<Bench<HydrophoneArray.Heard>> benches() {
    MemoryLink wire = new MemoryLink();
    return List.of(
        new LinkedBench<>(
            "NMEA",
            wire,
            new NmeaHydrophones(wire),
            500_000,
            line -> line.fromDevice(Nmea.bytes("YXPNG,25000,270.0,-45.0,2.0"))),
        new SimulatedBench<>(
            "simulated",
            new SimulatedHydrophones(
                new SensorErrors(2.0, 0.1, 0.01, 0.01, 0.0),
                25_000.0,
                Point.of(-20.0, 0.0, -20.0),
                new NoiseStreams(1),
                () -> NORTH)));
  }

  @Override
  protected void judge(HydrophoneArray.Heard heard) {
    HydrophoneArray.Ping ping = (HydrophoneArray.Ping) heard;
    assertThat(ping.frequencyHz()).isEqualTo(25_000.0);
    assertThat(ping.azimuthRad()).as("to the left").isCloseTo(Math.PI / 2.0, within(0.1));
    assertThat(ping.elevationRad()).as("down").isCloseTo(-Math.PI / 4.0, within(0.1));
    assertThat(ping.sigmaRad().orElseThrow()).isBetween(0.01, 0.04);
  }
}
