package org.u2sa.drivers.sonar;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.u2sa.device.SonarSensor;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.RangeScan;
import org.u2sa.testkit.ServiceKit;

class PingTest {
  private final MemoryLink link = new MemoryLink();
  private final SimulatedPing far = new SimulatedPing(link, 7.0, true);

  @Test
  void ping360_told_turnsClockwiseStepByStep() {
    Ping360 sonar = new Ping360(link, 20.0, 1500.0, 100, 1);
    for (int i = 0; i < 7; i++) {
      sonar.read(i * 20_000L);
    }
    assertThat(far.angles()).startsWith(0, 100, 200, 300, 0, 100);
    assertThat(sonar.malformed()).isZero();
  }

  @Test
  void ping360_quarterTurn_isToTheRight() {
    Ping360 sonar = new Ping360(link, 20.0, 1500.0, 100, 1);
    sonar.read(0);
    sonar.read(20_000);
    assertThat(sonar.read(40_000).orElseThrow().bearingRad()).isCloseTo(-Math.PI / 2, within(1e-9));
  }

  @Test
  void ping360_service_publishesScansOfTheTank() {
    try (ServiceKit kit = new ServiceKit()) {
      kit.with("PINGS PER SCAN", 10).with("MOUNTED X", 0.5);
      kit.start(context -> new SonarSensor(context, new Ping360(link, 20.0, 1500.0, 4, 1)));
      kit.advance(2.0);
      RangeScan scan = kit.published(Channels.SCANS).get(1);
      assertThat(scan.beams()).hasSize(10);
      assertThat(scan.beams()).allMatch(beam -> Math.abs(beam.range().orElseThrow() - 7.0) < 0.05);
      assertThat(scan.beams().get(1).angle() - scan.beams().get(0).angle())
          .isCloseTo(-4.0 * Math.PI / 200.0, within(1e-9));
      assertThat(scan.maxRange()).isCloseTo(20.0, within(0.1));
      assertThat(scan.x()).isEqualTo(0.5);
      assertThat(scan.sensorName()).isEqualTo("SonarSensor");
    }
  }

  @Test
  void ping360_thresholdAboveTheEcho_beamsAreFree() {
    try (ServiceKit kit = new ServiceKit()) {
      kit.with("THRESHOLD", 255);
      kit.start(context -> new SonarSensor(context, new Ping360(link, 20.0, 1500.0, 4, 1)));
      kit.advance(2.0);
      assertThat(kit.latest(Channels.SCANS).orElseThrow().beams())
          .isNotEmpty()
          .allMatch(beam -> beam.range().isEmpty());
    }
  }

  @Test
  void ping1d_unsureEcho_isNone() {
    Ping1d sounder = new Ping1d(link, 50);
    sounder.read(0);
    assertThat(sounder.read(20_000).orElseThrow().rangeM()).hasValue(7.0);
    far.confidence(20);
    sounder.read(120_000);
    assertThat(sounder.read(140_000).orElseThrow().rangeM()).isEmpty();
  }

  @Test
  void framer_noise_neverThrowsAndFindsTheNextMessage() {
    Random random = new Random(1);
    byte[] message = PingFramer.of(1211, new byte[] {1, 2, 3, 4, 5});
    for (int run = 0; run < 200; run++) {
      List<Integer> found = new ArrayList<>();
      PingFramer framer = new PingFramer((payload, id) -> found.add(id), why -> {});
      byte[] noise = new byte[random.nextInt(200)];
      random.nextBytes(noise);
      framer.accept(noise, noise.length);
      for (int i = 0; i < 300; i++) {
        framer.accept(message, message.length);
      }
      assertThat(found).as("run %d", run).contains(1211);
    }
  }

  @Test
  void framer_longMessageCutAnywhere_isWhole() {
    byte[] message = PingFramer.of(2300, new byte[614]);
    List<Integer> found = new ArrayList<>();
    PingFramer framer = new PingFramer((payload, id) -> found.add(payload.capacity()), why -> {});
    for (byte each : message) {
      framer.accept(new byte[] {each}, 1);
    }
    assertThat(found).containsExactly(614);
  }
}
