package org.u2sa.drivers.range;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.u2sa.device.port.RangeFinder;
import org.u2sa.drivers.link.LinkedBench;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.drivers.link.SimulatedBench;
import org.u2sa.drivers.nmea.Nmea;
import org.u2sa.drivers.sonar.NmeaDepth;
import org.u2sa.drivers.sonar.SerialSonar;
import org.u2sa.drivers.sonar.SonarModel;
import org.u2sa.sim.device.SimulatedRangeFinder;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.testkit.DeviceContract;

/** Every range finder, 1.27 m before a wall. */
class RangeFinderPortTest extends DeviceContract<RangeFinder.Distance> {
  private static final double WALL_M = 1.27;

  @Override
  protected List<Bench<RangeFinder.Distance>> benches() {
    MemoryLink sounder = new MemoryLink();
    return List.of(
        new LinkedBench<>(
            "NMEA",
            sounder,
            new NmeaDepth(sounder),
            100_000,
            line -> line.fromDevice(Nmea.bytes("SDDPT,1.27,0.5,100"))),
        sonar(SonarModel.LV, "R050\r"),
        sonar(SonarModel.XL, "R127\r"),
        sonar(SonarModel.HR, "R1270\r"),
        new SimulatedBench<>(
            "simulated",
            new SimulatedRangeFinder("sonar", 10.0, 5.0, 0.01, new NoiseStreams(1), () -> WALL_M)));
  }

  private static Bench<RangeFinder.Distance> sonar(SonarModel model, String line) {
    MemoryLink link = new MemoryLink();
    return new LinkedBench<>(
        model.name(),
        link,
        new SerialSonar(link, model),
        100_000,
        device -> device.fromDevice(line.getBytes(US_ASCII)));
  }

  @Override
  protected void judge(RangeFinder.Distance distance) {
    assertThat(distance.rangeM().orElseThrow()).isCloseTo(WALL_M, within(0.1));
  }
}
