package org.u2sa.drivers.compass;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.u2sa.device.port.Heading;
import org.u2sa.drivers.link.LinkedBench;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.drivers.link.SimulatedBench;
import org.u2sa.drivers.nmea.Nmea;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.device.SimulatedCompass;
import org.u2sa.sim.sensor.CompassModel;
import org.u2sa.sim.sensor.CompassParameters;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.testkit.DeviceContract;

/** Every compass, its front to the east. */
class CompassPortTest extends DeviceContract<Heading> {
  @Override
  protected List<Bench<Heading>> benches() {
    MemoryLink nmea = new MemoryLink();
    MemoryLink sparton = new MemoryLink();
    sparton.with(
        asked -> sparton.fromDevice((byte) 0xA4, (byte) 0x09, (byte) 4, (byte) 0, (byte) 0xA0));
    VehicleTruth truth =
        new VehicleTruth(
            0.0,
            Point.of(0.0, 0.0, 0.0),
            new Attitude(0.0, 0.0, Math.PI / 2.0),
            Point.of(0.0, 0.0, 0.0),
            Point.ORIGIN,
            Point.ORIGIN);
    return List.of(
        new LinkedBench<>(
            "NMEA",
            nmea,
            LinkedCompass.nmea(nmea),
            100_000,
            link -> link.fromDevice(Nmea.bytes("HCHDM,90.0,M"))),
        new LinkedBench<>("Sparton", sparton, LinkedCompass.sparton(sparton), 100_000, link -> {}),
        new SimulatedBench<>(
            "simulated",
            new SimulatedCompass(
                CompassParameters.calibrated(0.0),
                new NoiseStreams(1),
                () -> truth,
                CompassModel.Disturbance::none)));
  }

  @Override
  protected void judge(Heading heading) {
    assertThat(heading.isTrue()).isFalse();
    assertThat(Math.toDegrees(heading.headingRad())).isCloseTo(90.0, within(3.0));
  }
}
