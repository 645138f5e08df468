package org.u2sa.drivers.range;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.device.RangeSensor;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.drivers.sonar.SerialSonar;
import org.u2sa.drivers.sonar.SonarModel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.testkit.ServiceKit;

/** A sonar at the left side of the vehicle. */
class RangeSensorTest {
  private final ServiceKit kit =
      new ServiceKit()
          .with("MOUNTED Y", 0.4)
          .with("MOUNTED YAW", Math.PI / 2.0)
          .with("SENSOR NAME", "LEFT SONAR");
  private final MemoryLink link = new MemoryLink();

  @AfterEach
  void end() {
    kit.close();
  }

  private void start() {
    kit.start(context -> new RangeSensor(context, new SerialSonar(link, SonarModel.LV)));
  }

  private void say(String text) {
    link.fromDevice(text.getBytes(US_ASCII));
    kit.advance(0.05);
  }

  @Test
  void step_measurement_isAPointInBody() {
    start();
    say("R050\r");
    ObjectDescription seen = kit.latest(Channels.SENSED_OBJECTS).orElseThrow();
    assertThat(seen.referenceFrame()).isEqualTo(ReferenceFrame.BODY);
    assertThat(seen.uid()).isEqualTo("LEFT SONAR");
    assertThat(seen.x()).isCloseTo(0.0, within(1.0e-9));
    assertThat(seen.y()).isCloseTo(0.4 + 1.27, within(1.0e-9));
    assertThat(seen.timestamp()).hasValue(20_000);
  }

  @Test
  void step_nothingInReach_saysNothing() {
    start();
    say("R255\r");
    kit.advance(1.0);
    assertThat(kit.published(Channels.SENSED_OBJECTS)).isEmpty();
  }

  @Test
  void step_unpluggedInMidLineAndGarbage_saysSoAndGoesOn() {
    start();
    say("R050\rR0");
    link.unplug();
    kit.advance(1.0);
    assertThat(kit.latest(Channels.HEALTH).flatMap(HealthReport::lastError))
        .hasValue("the range finder is lost: unplugged");
    link.plug();
    kit.forget();
    say("99\r\u0000\u00ffx");
    assertThat(kit.published(Channels.SENSED_OBJECTS)).isEmpty();
    say("R100\r");
    assertThat(kit.published(Channels.SENSED_OBJECTS)).hasSize(1);
    kit.advance(2.0);
    HealthReport health = kit.latest(Channels.HEALTH).orElseThrow();
    assertThat(health.exceptions()).isZero();
    assertThat(health.lastError())
        .hasValueSatisfying(e -> assertThat(e).contains("sent no valid data"));
  }
}
