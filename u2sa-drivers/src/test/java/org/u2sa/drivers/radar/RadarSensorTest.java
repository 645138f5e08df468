package org.u2sa.drivers.radar;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.u2sa.device.RadarSensor;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.drivers.nmea.Nmea;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.ObjectLevel;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.MovingSphere;
import org.u2sa.testkit.ServiceKit;

/** The service of a radar, at 20° W 40° N, heading east. */
class RadarSensorTest {
  private static final Geodetic HERE = new Geodetic(-20.0, 40.0, 0.0);
  private static final String SHIP_AHEAD = "RATTM,7,1.0,0.0,R,10.0,0.0,T,,,N,,T,,,A";

  private final ServiceKit kit = new ServiceKit();
  private final MemoryLink link = new MemoryLink();

  @BeforeEach
  void describe() {
    kit.with("SEPARATION", 400.0).with("BEARING SIGMA", 0.02);
  }

  @AfterEach
  void end() {
    kit.close();
  }

  private void start() {
    kit.start(context -> new RadarSensor(context, new NmeaRadar(link)));
    kit.advance(0.1);
  }

  private void state() {
    kit.publish(
        Channels.STATE,
        new StateInformation()
            .referenceFrame(ReferenceFrame.GLOBAL)
            .x(HERE.longitudeDeg())
            .y(HERE.latitudeDeg())
            .z(30.0)
            .psi(Math.PI / 2.0));
    kit.advance(0.1);
  }

  private void hear(String sentence) {
    link.fromDevice(Nmea.bytes(sentence));
    kit.advance(0.2);
  }

  private MovingSphere last() {
    return (MovingSphere) kit.latest(Channels.SENSED_OBJECTS).orElseThrow();
  }

  @Test
  void step_shipAheadOfAnEastboundVehicle_isASphereToTheEast() {
    start();
    state();
    hear(SHIP_AHEAD);

    MovingSphere ship = last();
    assertThat(ship.uid()).isEqualTo("traffic RadarSensor 7");
    assertThat(ship.level()).hasValue(ObjectLevel.AVOID_ALWAYS);
    assertThat(ship.radius()).isEqualTo(400.0);
    Point away = HERE.enuOf(new Geodetic(ship.x(), ship.y(), 0.0));
    assertThat(away.x()).isCloseTo(1852.0, within(2.0));
    assertThat(away.y()).isCloseTo(0.0, within(2.0));
    assertThat(ship.z()).as("its own altitude").isEqualTo(30.0);
    assertThat(ship.motion().velocity().orElseThrow().y()).isCloseTo(5.144, within(0.001));
    assertThat(ship.motion().sigma().orElseThrow().x()).isCloseTo(0.02 * 1852.0, within(0.01));
  }

  @Test
  void step_radarMountedToTheLeft_bearingsCountFromThere() {
    kit.with("MOUNTED YAW", Math.PI / 2.0); // its zero is to the north
    start();
    state();
    hear(SHIP_AHEAD);

    Point away = HERE.enuOf(new Geodetic(last().x(), last().y(), 0.0));
    assertThat(away.y()).isCloseTo(1852.0, within(2.0));
  }

  @Test
  void step_noStateYet_publishesNothingAndLosesNothing() {
    start();
    hear(SHIP_AHEAD);
    assertThat(kit.published(Channels.SENSED_OBJECTS)).isEmpty();

    state();
    hear("RATTM,8,2.0,0.0,R,10.0,0.0,T,,,N,,T,,,A");
    assertThat(kit.published(Channels.SENSED_OBJECTS)).hasSize(2);
  }

  @Test
  void step_nothingNew_isPublishedOnce() {
    start();
    state();
    hear(SHIP_AHEAD);
    kit.advance(3.0);

    assertThat(kit.published(Channels.SENSED_OBJECTS)).hasSize(1);
  }

  @Test
  void step_noTarget_isSaidWithConfidenceZero() {
    start();
    state();
    hear("RARSD,,,,,,,,,,,6.0,N,H");

    assertThat(last().confidence()).hasValue(0.0);
    assertThat(last().sensorName()).isEqualTo("RadarSensor");
    assertThat(HERE.distanceM(new Geodetic(last().x(), last().y(), 0.0))).isLessThan(0.1);
  }
}
