package org.u2sa.drivers.radar;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.u2sa.device.port.TrackingRadar;
import org.u2sa.drivers.link.LinkedBench;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.drivers.link.SimulatedBench;
import org.u2sa.drivers.nmea.Nmea;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.device.SensorErrors;
import org.u2sa.sim.device.SimulatedRadar;
import org.u2sa.sim.device.SimulatedTraffic;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.testkit.DeviceContract;

/** Every radar on a vehicle that points east: a target 1852 m ahead moves north at 5.144 m/s. */
class RadarPortTest extends DeviceContract<TrackingRadar.Tracks> {
  private static final VehicleTruth EAST =
      new VehicleTruth(
          0.0,
          Point.ORIGIN,
          new Attitude(0.0, 0.0, Math.PI / 2.0),
          Point.ORIGIN,
          Point.ORIGIN,
          Point.ORIGIN);

  @Override
  protected List<Bench<TrackingRadar.Tracks>> benches() {
    MemoryLink wire = new MemoryLink();
    SimulatedTraffic.Other ship =
        new SimulatedTraffic.Other(
            "7", "ship", Point.of(1852.0, 0.0, 0.0), Point.of(0.0, 5.144, 0.0));
    return List.of(
        new LinkedBench<>(
            "NMEA",
            wire,
            new NmeaRadar(wire),
            250_000,
            line ->
                line.fromDevice(
                    Nmea.bytes("RATTM,7,1.0,0.0,R,10.0,0.0,T,0.0,0.0,N,,T,,120000.00,A"))),
        new SimulatedBench<>(
            "simulated",
            new SimulatedRadar(
                new SensorErrors(2.0, 0.1, 5.0, 0.0, 0.0),
                5_000.0,
                0.005,
                new NoiseStreams(1),
                () -> EAST,
                () -> List.of(ship))));
  }

  @Override
  protected void judge(TrackingRadar.Tracks reading) {
    assertThat(reading.tracks()).hasSize(1);
    TrackingRadar.Track track = reading.tracks().get(0);
    assertThat(track.id()).isEqualTo("7");
    assertThat(track.rangeM()).isCloseTo(1852.0, within(30.0));
    assertThat(track.bearing().isTrue()).isFalse();
    assertThat(track.bearing().rad()).isCloseTo(0.0, within(0.03));
    assertThat(track.speedMps().orElseThrow()).isCloseTo(5.144, within(0.01));
    assertThat(track.course().orElseThrow().rad()).isCloseTo(0.0, within(1e-9));
  }
}
