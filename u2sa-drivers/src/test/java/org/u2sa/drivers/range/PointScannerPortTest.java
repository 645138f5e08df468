package org.u2sa.drivers.range;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.u2sa.device.port.PointScanner;
import org.u2sa.drivers.link.LinkedBench;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.drivers.link.SimulatedBench;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.device.SimulatedPointScanner;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.testkit.DeviceContract;

/** Every 3-D scanner, 4 m behind a wall that spans the view ahead. */
class PointScannerPortTest extends DeviceContract<PointScanner.Cloud> {
  private static final double WALL_M = 4.0;

  @Override
  protected List<Bench<PointScanner.Cloud>> benches() {
    MemoryLink wire = new MemoryLink();
    byte[] revolution =
        VelodynePackets.revolutions(
            1,
            (azimuth, elevation) -> {
              double ahead =
                  Math.cos(Math.toRadians(azimuth)) * Math.cos(Math.toRadians(elevation));
              return ahead > 0.7 ? WALL_M / ahead : 0.0;
            });
    return List.of(
        new LinkedBench<>(
            "VLP-16", wire, new Velodyne(wire), 100_000, line -> line.fromDevice(revolution)),
        new SimulatedBench<>(
            "simulated",
            new SimulatedPointScanner(
                new SimulatedPointScanner.Optics(10.0, 1.2, 20, 0.5, 8, 0.3, 50.0, 0.01),
                new NoiseStreams(1),
                () -> direction -> WALL_M / direction.x())));
  }

  @Override
  protected void judge(PointScanner.Cloud cloud) {
    assertThat(cloud.points()).hasSizeGreaterThan(100);
    for (Point point : cloud.points()) {
      assertThat(point.x()).isCloseTo(WALL_M, within(0.1));
    }
    assertThat(cloud.points()).anyMatch(point -> point.y() > 1.0).anyMatch(point -> point.y() < -1);
    assertThat(cloud.points()).anyMatch(point -> point.z() < -0.5);
  }
}
