package org.u2sa.drivers.sonar;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.device.payload.PingerSensor;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.drivers.nmea.Nmea;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.testkit.ServiceKit;

/** The service of a hydrophone array, from the bytes of its processor. */
class PingerSensorTest {
  private final ServiceKit kit = new ServiceKit();
  private final MemoryLink link = new MemoryLink();

  @AfterEach
  void end() {
    kit.close();
  }

  private void hear(String sentence) {
    kit.start(context -> new PingerSensor(context, new NmeaHydrophones(link)));
    kit.advance(0.1);
    link.fromDevice(Nmea.bytes(sentence));
    kit.advance(0.2);
  }

  private ObjectDescription pinger() {
    return kit.latest(Channels.SENSED_OBJECTS).orElseThrow();
  }

  @Test
  void step_pingFromTheRight_isAPointThereUnsureAlongTheDirection() {
    kit.with("RANGE", 20.0).with("RANGE SIGMA", 15.0).with("MOUNTED X", 1.0);
    hear("YXPNG,25000,90.0,0.0,3.0");

    assertThat(pinger().uid()).isEqualTo("pinger 25.0");
    assertThat(pinger().objectType()).isEqualTo("pinger");
    assertThat(pinger().referenceFrame()).isEqualTo(ReferenceFrame.BODY);
    assertThat(pinger().center().minus(Point.of(1.0, -20.0, 0.0)).distance()).isLessThan(1e-9);
    Point sigma = pinger().motion().sigma().orElseThrow();
    assertThat(sigma.x()).isCloseTo(20.0 * Math.toRadians(3.0), within(1e-9));
    assertThat(sigma.y()).isCloseTo(15.0, within(1e-9));
    assertThat(sigma.z()).isCloseTo(20.0 * Math.toRadians(3.0), within(1e-9));
  }

  @Test
  void step_pingFromBelowWithoutSigma_isBelowWithTheUsualOne() {
    hear("YXPNG,25000,0.0,-30.0,");

    assertThat(pinger().z()).as("down").isCloseTo(5.0, within(1e-9));
    assertThat(pinger().motion().sigma().orElseThrow().y()).isCloseTo(1.0, within(1e-9));
  }

  @Test
  void step_arrayTurnedDown_isMadeGoodByItsMounting() {
    kit.with("MOUNTED PITCH", -Math.PI / 2.0);
    hear("YXPNG,25000,0.0,0.0,1.0");

    assertThat(pinger().center().minus(Point.of(0.0, 0.0, 10.0)).distance()).isLessThan(1e-9);
  }

  private void hearTimes(String sentence) {
    kit.with("HYDROPHONE PLACES", "0.1 0 0; -0.1 0 0; 0 0.1 0; 0 0 0.1").with("RANGE", 5.0);
    hear(sentence);
  }

  @Test
  void step_arrivalTimesOfAPingFromTheLeft_isAPointThere() {
    hearTimes("YXTOA,30000,100.0,100.0,33.333,100.0"); // 0.1 m at 1500 m/s

    assertThat(pinger().center().minus(Point.of(0.0, 5.0, 0.0)).distance()).isLessThan(1e-3);
    Point sigma = pinger().motion().sigma().orElseThrow();
    assertThat(sigma.x()).as("by 2 µs at 0.1 m").isBetween(0.05, 0.4);
  }

  @Test
  void step_oneHydrophoneHearsAnEcho_isNone() {
    hearTimes("YXTOA,30000,100.0,100.0,33.333,600.0");

    assertThat(kit.published(Channels.SENSED_OBJECTS)).isEmpty();
  }

  @Test
  void step_anotherNumberOfArrivalsThanHydrophones_isNone() {
    hearTimes("YXTOA,30000,100.0,100.0,33.333");

    assertThat(kit.published(Channels.SENSED_OBJECTS)).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "YXPNG,31000,0.0,0.0,1.0",
        "YXPNG,25000,0.0,91.0,1.0",
        "YXPNG,NaN,0.0,0.0,1.0",
        "YXPNG,25000"
      })
  void step_otherPingerOrNonsense_isNone(String sentence) {
    kit.with("FREQUENCY", 25_000.0);
    hear(sentence);

    assertThat(kit.published(Channels.SENSED_OBJECTS)).isEmpty();
  }
}
