package org.u2sa.drivers.sonar;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.u2sa.device.port.Sonar;
import org.u2sa.drivers.link.LinkedBench;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.drivers.link.SimulatedBench;
import org.u2sa.sim.device.SimulatedSonar;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.testkit.DeviceContract;

/** Every sonar in the middle of a round tank of 7 m. */
class SonarPortTest extends DeviceContract<Sonar.Ping> {
  @Override
  protected List<Bench<Sonar.Ping>> benches() {
    MemoryLink link = new MemoryLink();
    SimulatedPing far = new SimulatedPing(link, 7.0, false);
    return List.of(
        new LinkedBench<>(
            "Ping360", link, new Ping360(link, 20.0, 1500.0, 4, 1), 50_000, line -> far.deliver()),
        new SimulatedBench<>(
            "simulated",
            new SimulatedSonar(
                new SimulatedSonar.Head(10.0, -0.1, 600, 20.0),
                new NoiseStreams(1),
                bearing -> 7.0)));
  }

  @Override
  protected void judge(Sonar.Ping ping) {
    assertThat(ping.reachM()).isCloseTo(20.0, within(0.1));
    int strongest = 0;
    for (int i = 0; i < ping.strengths().length; i++) {
      if ((ping.strengths()[i] & 0xFF) > (ping.strengths()[strongest] & 0xFF)) {
        strongest = i;
      }
    }
    assertThat(ping.rangeM(strongest)).isCloseTo(7.0, within(0.1));
    assertThat(ping.bearingRad()).isBetween(-Math.PI, Math.PI);
  }
}
