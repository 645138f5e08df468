package org.u2sa.world.bearing;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.world.modeller.MapFrame;
import org.u2sa.world.modeller.Sighting;

class BearingModellerTest {
  private static final Point PINGER = Point.of(14.0, 3.0, 4.5); // north, east, down [m]
  private static final double SIGMA_RAD = 0.03;

  private final BearingModeller modeller =
      new BearingModeller(XmlConfiguration.inMemory("test", Map.of("BEARING SIGMA", SIGMA_RAD)));

  private static StateInformation state(Point at, double psi) {
    StateInformation state = new StateInformation().referenceFrame(ReferenceFrame.LOCAL_NED);
    return state.x(at.x()).y(at.y()).z(at.z()).psi(psi);
  }

  /** The pinger's direction from a place, put at 10 m. */
  private static ObjectDescription heard(Point from, Point to, double psi, Random noise) {
    Point body = new Attitude(0.0, 0.0, psi).bodyOf(to.minus(from));
    double azimuth = Math.atan2(body.y(), body.x()) + SIGMA_RAD * noise.nextGaussian();
    double down = Math.atan2(body.z(), Math.hypot(body.x(), body.y()));
    down += SIGMA_RAD * noise.nextGaussian();
    ObjectDescription object = new ObjectDescription();
    object
        .uid("pinger 30.0")
        .objectType("pinger")
        .sensorName("PingerSensor")
        .referenceFrame(ReferenceFrame.BODY)
        .x(10.0 * Math.cos(down) * Math.cos(azimuth))
        .y(10.0 * Math.cos(down) * Math.sin(azimuth))
        .z(10.0 * Math.sin(down));
    return object;
  }

  private Point passBy(Random noise, boolean withEchoes) {
    Sighting now = null;
    for (int i = 0; i < 30; i++) {
      Point at = Point.of(0.4 * i, 0.05 * i, 1.5);
      double psi = 0.2 * Math.sin(0.3 * i);
      StateInformation state = state(at, psi);
      now = new Sighting(i * 1_000_000L, MapFrame.of(state), Optional.of(state));
      if (i == 0) {
        modeller.enter(now.frame(), now);
      }
      Point echo = Point.of(-3.0 + i, 9.0, 0.0);
      boolean isEcho = withEchoes && i % 6 == 3;
      ObjectDescription object = heard(at, isEcho ? echo : PINGER, psi, noise);
      object.timestamp(now.micros());
      modeller.objects(List.of(object), now);
    }
    ObjectDescription found = modeller.objects(now).get(0);
    assertThat(found.referenceFrame()).isEqualTo(ReferenceFrame.LOCAL_NED);
    return found.center();
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5})
  void objects_directionsFromAPass_locateThePinger(long seed) {
    assertThat(passBy(new Random(seed), false).distanceTo(PINGER)).isLessThan(0.7);
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5})
  void objects_everySixthAnEcho_theOthersLocateThePinger(long seed) {
    assertThat(passBy(new Random(seed), true).distanceTo(PINGER)).isLessThan(1.0);
  }

  @Test
  void objects_withoutAState_isTheNewestDirectionInBodyForAWhile() {
    Sighting first = new Sighting(0L, MapFrame.BODY, Optional.empty());
    ObjectDescription object = heard(Point.ORIGIN, PINGER, 0.0, new Random(1));
    object.timestamp(0L);
    modeller.objects(List.of(object), first);

    assertThat(modeller.objects(first)).containsExactly(object);
    Sighting late = new Sighting(6_000_000L, MapFrame.BODY, Optional.empty());
    assertThat(modeller.objects(late)).isEmpty();
  }
}
