package org.u2sa.world.object;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.world.object.MappedObject.Source;

/** Names that come from where their objects are not. */
class MappedObjectTest {
  private static final long SECOND = 1_000_000;
  private static final double SIGMA = 0.1;

  private final ObjectMapVariables settings =
      XmlConfiguration.inMemory(
              "test",
              Map.of("TRUST UIDS", true, "USUAL SPEED", 0.5, "MOVERS", "robot", "MANOEUVRES", 0.1))
          .settings(ObjectMapVariables.class)
          .get();

  private MappedObject standing(String type) {
    MappedObject object = new MappedObject(type, at(0.0, type), 0, settings, Source.SENSOR);
    for (int second = 1; second <= 20; second++) {
      object.predict(second * SECOND, settings);
      assertThat(object.hit(at(0.0, type), second * SECOND, Source.SENSOR, settings)).isTrue();
    }
    return object;
  }

  private static Detection at(double x, String type) {
    ObjectDescription object =
        new ObjectDescription().uid(type).objectType(type).sensorName("camera");
    return new Detection(object, Point.of(x, 0.0, 0.0), Point.of(SIGMA, SIGMA, SIGMA));
  }

  @Test
  void hit_nameFarFromALandmark_isRefusedUntilTheFourthTime() {
    MappedObject landmark = standing("landmark");
    for (int time = 1; time <= 3; time++) {
      landmark.predict((20 + 60 * time) * SECOND, settings);
      assertThat(
              landmark.hit(at(6.0, "landmark"), (20 + 60 * time) * SECOND, Source.SENSOR, settings))
          .isFalse();
      assertThat(landmark.place().x()).isCloseTo(0.0, within(SIGMA));
    }
    assertThat(landmark.hit(at(6.0, "landmark"), 261 * SECOND, Source.SENSOR, settings)).isTrue();
    assertThat(landmark.place().x()).isEqualTo(6.0);
  }

  @Test
  void hit_refusedThenSeenInItsPlace_isRefusedThreeTimesMore() {
    MappedObject landmark = standing("landmark");
    for (int time = 0; time < 9; time++) {
      double x = time % 3 == 2 ? 0.0 : 6.0;
      assertThat(landmark.hit(at(x, "landmark"), (21 + time) * SECOND, Source.SENSOR, settings))
          .isEqualTo(x == 0.0);
    }
  }

  @Test
  void hit_moverUnseenForLong_isWhereItIsSeenAgain() {
    MappedObject robot = standing("robot");
    robot.predict(50 * SECOND, settings);
    assertThat(robot.hit(at(20.0, "robot"), 50 * SECOND, Source.SENSOR, settings)).isTrue();
    assertThat(robot.place().x()).isEqualTo(20.0);
    assertThat(robot.filter().sigma().x()).isGreaterThanOrEqualTo(SIGMA);
  }

  @Test
  void hit_moverFartherThanItCanHaveGone_isRefused() {
    MappedObject robot = standing("robot");
    robot.predict(21 * SECOND, settings);
    assertThat(robot.hit(at(6.0, "robot"), 21 * SECOND, Source.SENSOR, settings)).isFalse();
    assertThat(robot.place().x()).isCloseTo(0.0, within(SIGMA));
  }
}
