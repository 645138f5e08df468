package org.u2sa.world.object;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.shape.Cylinder;
import org.u2sa.world.object.MappedObject.Source;

/** An aircraft with a transponder flies over a mast of 30 m radius that a file names. */
class SightingMatchTest {
  private static final long SECOND = 1_000_000;
  private static final Point SIGMA = Point.of(3.0, 3.0, 3.0);

  private final ObjectMapVariables settings =
      XmlConfiguration.inMemory("test", Map.of("TRUST UIDS", true, "USUAL SPEED", 25.0))
          .settings(ObjectMapVariables.class)
          .get();
  private final MappedObject mast =
      new MappedObject(
          "mast", placed(new Cylinder().radius(30.0).height(60.0), 0.0), 0, settings, Source.FILE);

  private static Detection placed(ObjectDescription object, double x) {
    return new Detection(object.x(x).y(0.0).z(0.0), Point.of(x, 0.0, 0.0), SIGMA);
  }

  private static Detection aircraft(double x, double speedMps) {
    ObjectDescription object = new ObjectDescription().uid("aircraft 1").sensorName("receiver");
    object.motion().velocity(Point.of(speedMps, 0.0, 0.0)).velocitySigma(5.0);
    return placed(object, x);
  }

  private int match(List<MappedObject> tracks, Detection detection) {
    return new SightingMatch(tracks, settings).of(List.of(detection))[0];
  }

  @Test
  void of_knownAircraftAboveTheMast_isTheAircraft() {
    MappedObject known =
        new MappedObject("aircraft 1", aircraft(-10.0, 10.0), 0, settings, Source.SENSOR);
    known.predict(SECOND, settings);

    assertThat(match(List.of(mast, known), aircraft(0.0, 10.0))).isEqualTo(1);
  }

  @Test
  void of_fastAircraftFirstHeardAboveTheMast_isNew() {
    assertThat(match(List.of(mast), aircraft(0.0, 20.0))).isEqualTo(SightingMatch.NONE);
  }

  @Test
  void of_movingSightingOfAMoverOfTheFile_isThatMover() {
    MappedObject cart = new MappedObject("cart", aircraft(0.0, 20.0), 0, settings, Source.FILE);

    assertThat(match(List.of(cart), aircraft(0.0, 20.0))).isZero();
  }

  /** Slow, it may be the mast itself; once it is elsewhere, it is not. */
  @Test
  void of_slowAircraftTakenForTheMast_isNewWhenItIsElsewhere() {
    assertThat(match(List.of(mast), aircraft(0.0, 1.0))).isZero();
    mast.hit(aircraft(0.0, 1.0), SECOND, Source.SENSOR, settings);

    assertThat(match(List.of(mast), aircraft(200.0, 1.0))).isEqualTo(SightingMatch.NONE);
  }
}
