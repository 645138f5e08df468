package org.u2sa.drivers.traffic;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.u2sa.device.port.TrafficReceiver;
import org.u2sa.device.port.TrafficTarget;
import org.u2sa.drivers.link.LinkedBench;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.drivers.link.SimulatedBench;
import org.u2sa.drivers.mavlink.AdsbFrames;
import org.u2sa.drivers.mavlink.MavlinkTraffic;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.device.SensorErrors;
import org.u2sa.sim.device.SimulatedTraffic;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.world.LocalPlane;
import org.u2sa.testkit.DeviceContract;

/** Every receiver, hearing the aircraft of GDL 90's example: 5,000 ft, 123 kn to the north-east. */
class TrafficPortTest extends DeviceContract<TrafficReceiver.Traffic> {
  private static final LocalPlane SALEM = new LocalPlane(new Geodetic(-122.99488, 44.90708, 0.0));

  @Override
  protected List<Bench<TrafficReceiver.Traffic>> benches() {
    MemoryLink gdl = new MemoryLink();
    MemoryLink mavlink = new MemoryLink();
    SimulatedTraffic.Other other =
        new SimulatedTraffic.Other(
            "AB4549",
            "aircraft",
            Point.of(0.0, 0.0, 1524.0),
            Point.of(44.74, 44.74, 64.0 * 0.3048 / 60.0));
    return List.of(
        new LinkedBench<>(
            "GDL 90",
            gdl,
            new Gdl90Receiver(gdl),
            100_000,
            line -> line.fromDevice(Gdl90ParserTest.framed(Gdl90ParserTest.EXAMPLE_REPORT))),
        new LinkedBench<>(
            "MAVLink",
            mavlink,
            new MavlinkTraffic(mavlink),
            100_000,
            line -> line.fromDevice(AdsbFrames.example())),
        new SimulatedBench<>(
            "simulated",
            new SimulatedTraffic(
                new SensorErrors(5.0, 0.1, 2.0, 0.0, 0.2),
                50_000.0,
                SALEM,
                new NoiseStreams(1),
                () -> Point.ORIGIN,
                () -> List.of(other))));
  }

  @Override
  protected void judge(TrafficReceiver.Traffic traffic) {
    if (traffic.targets().isEmpty()) {
      return; // simulated: the first report may be lost
    }
    TrafficTarget target = traffic.targets().get(0);
    assertThat(traffic.targets()).hasSize(1);
    assertThat(target.id()).isEqualTo("AB4549");
    assertThat(
            SALEM.point(new Geodetic(target.longitudeDeg(), target.latitudeDeg(), 0.0)).distance())
        .isLessThan(10.0);
    assertThat(target.altitudeM().orElseThrow()).isCloseTo(1524.0, within(10.0));
    Point velocity = target.velocity().orElseThrow();
    assertThat(velocity.x()).isCloseTo(44.74, within(0.05));
    assertThat(velocity.y()).isCloseTo(44.74, within(0.05));
    assertThat(velocity.z()).isCloseTo(0.325, within(0.01));
  }
}
