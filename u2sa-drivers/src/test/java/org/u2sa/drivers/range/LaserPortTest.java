package org.u2sa.drivers.range;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.function.BiConsumer;
import java.util.function.Function;
import java.util.function.LongSupplier;
import org.u2sa.device.port.LaserScanner;
import org.u2sa.drivers.link.LinkedBench;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.drivers.link.SimulatedBench;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.device.SimulatedLaser;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.testkit.DeviceContract;

/** Every laser, 3 m before a wall of which 60° to either side are seen; nothing elsewhere. */
class LaserPortTest extends DeviceContract<LaserScanner.Scan> {
  private static final double WALL_M = 3.0;
  private static final double EDGE_RAD = Math.toRadians(60.0);

  private static double distanceM(double bearingRad) {
    double off = Math.abs(Math.IEEEremainder(bearingRad, 2.0 * Math.PI));
    return off <= EDGE_RAD ? WALL_M / Math.cos(off) : Double.POSITIVE_INFINITY;
  }

  /** As the simulated devices take it: [deg], 0 m for nothing. */
  private static double wall(double degrees) {
    double rangeM = distanceM(Math.toRadians(degrees));
    return Double.isInfinite(rangeM) ? 0.0 : rangeM;
  }

  @Override
  protected List<Bench<LaserScanner.Scan>> benches() {
    return List.of(
        linked(
            "RPLIDAR",
            Rplidar::new,
            (link, clock) -> new SimulatedRplidar(link, clock, LaserPortTest::wall)),
        linked(
            "Hokuyo",
            Hokuyo::new,
            (link, clock) -> new SimulatedHokuyo(link, clock, LaserPortTest::wall)),
        new SimulatedBench<>(
            "simulated",
            new SimulatedLaser(
                SimulatedLaser.Optics.ust10lx(),
                new NoiseStreams(1),
                () -> (angle, cos, sin) -> distanceM(angle))));
  }

  private static Bench<LaserScanner.Scan> linked(
      String name,
      Function<MemoryLink, LaserScanner> driver,
      BiConsumer<MemoryLink, LongSupplier> far) {
    MemoryLink link = new MemoryLink();
    LinkedBench<LaserScanner.Scan> bench =
        new LinkedBench<>(name, link, driver.apply(link), Long.MAX_VALUE, line -> {});
    far.accept(link, bench::nowMicros);
    return bench;
  }

  @Override
  protected void judge(LaserScanner.Scan scan) {
    assertThat(scan.beams().timestamp().getAsLong()).isLessThanOrEqualTo(scan.measuredAtMicros());
    assertThat(scan.beams().returns()).contains(true).contains(false);
    assertThat(scan.beams().points())
        .allSatisfy(point -> assertThat(point.x()).isCloseTo(WALL_M, within(0.2)));
    assertThat(scan.beams().points().stream().mapToDouble(Point::y).max().orElseThrow())
        .isCloseTo(WALL_M * Math.tan(EDGE_RAD), within(0.3));
  }
}
