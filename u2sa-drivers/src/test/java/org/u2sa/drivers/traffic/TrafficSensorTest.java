package org.u2sa.drivers.traffic;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.device.TrafficSensor;
import org.u2sa.device.pressure.PressureAltitude;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectLevel;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.MovingSphere;
import org.u2sa.testkit.ServiceKit;

class TrafficSensorTest {
  private final ServiceKit kit = new ServiceKit();
  private final MemoryLink link = new MemoryLink();

  @AfterEach
  void end() {
    kit.close();
  }

  private void start() {
    kit.start(context -> new TrafficSensor(context, new Gdl90Receiver(link)));
    kit.advance(0.1);
  }

  private void hear(byte[] report) {
    link.fromDevice(Gdl90ParserTest.framed(report));
    kit.advance(0.1);
  }

  private MovingSphere only() {
    assertThat(kit.published(Channels.SENSED_OBJECTS)).hasSize(1);
    return (MovingSphere) kit.published(Channels.SENSED_OBJECTS).get(0);
  }

  @Test
  void step_report_isABallThatMoves() {
    start();
    hear(Gdl90ParserTest.EXAMPLE_REPORT);
    MovingSphere ball = only();
    assertThat(ball.uid()).isEqualTo("traffic AB4549");
    assertThat(ball.objectType()).isEqualTo("aircraft");
    assertThat(ball.referenceFrame()).isEqualTo(ReferenceFrame.GLOBAL);
    assertThat(ball.x()).isCloseTo(-122.99488, within(3e-5));
    assertThat(ball.y()).isCloseTo(44.90708, within(3e-5));
    assertThat(ball.z()).as("geometric").isCloseTo(1524.4, within(0.1));
    assertThat(ball.radius()).isEqualTo(150.0);
    assertThat(ball.level()).hasValue(ObjectLevel.AVOID_ALWAYS);
    assertThat(ball.motion().velocity().orElseThrow().x()).isCloseTo(44.74, within(0.01));
    assertThat(ball.motion().velocitySigma()).hasValue(2.0);
    assertThat(ball.motion().horizon()).hasValue(30.0);
    assertThat(ball.motion().sigma().orElseThrow().x()).isCloseTo(12.26, within(0.01));
    assertThat(ball.sensorName()).isEqualTo("TrafficSensor");
    assertThat(ball.timestamp()).isPresent();
  }

  @Test
  void step_nothingNew_isPublishedOnce() {
    start();
    hear(Gdl90ParserTest.EXAMPLE_REPORT);
    kit.advance(2.0);
    byte[] other = Gdl90ParserTest.EXAMPLE_REPORT.clone();
    other[4]++;
    hear(other);
    assertThat(kit.published(Channels.SENSED_OBJECTS).stream().map(ObjectDescription::uid))
        .containsExactly("traffic AB4549", "traffic AB454A");
  }

  @Test
  void step_lowPressureToday_isLower() {
    kit.with("QNH", 100_325.0);
    start();
    hear(Gdl90ParserTest.EXAMPLE_REPORT);
    assertThat(only().z())
        .isCloseTo(PressureAltitude.aboveSeaM(1524.0, 100_325.0), within(1e-9))
        .isLessThan(1524.0 - 70.0);
  }

  @Test
  void step_targetWithoutAltitude_isAtOurs() {
    start();
    kit.publish(
        Channels.STATE, new StateInformation().referenceFrame(ReferenceFrame.GLOBAL).z(640.0));
    byte[] report = Gdl90ParserTest.EXAMPLE_REPORT.clone();
    report[11] = (byte) 0xFF;
    report[12] = (byte) 0xF9;
    hear(report);
    assertThat(only().z()).isEqualTo(640.0);
    assertThat(only().motion().sigma().orElseThrow().z()).isEqualTo(3_000.0);
  }

  @Test
  void step_ourOwnTransponder_isNoTraffic() {
    kit.with("OWN ID", "ab4549");
    start();
    hear(Gdl90ParserTest.EXAMPLE_REPORT);
    assertThat(kit.published(Channels.SENSED_OBJECTS)).isEmpty();
  }
}
