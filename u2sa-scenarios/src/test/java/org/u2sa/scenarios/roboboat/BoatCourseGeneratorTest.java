package org.u2sa.scenarios.roboboat;

import static org.assertj.core.api.Assertions.assertThat;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.u2sa.messages.frame.Point;

class BoatCourseGeneratorTest {
  @Property
  void course_anySeed_isWithinTheRules(@ForAll int seed) {
    BoatCourse course = BoatCourseGenerator.course(seed);

    assertThat(course.speedGates()).hasSize(2);
    assertThat(course.channel()).hasSizeBetween(10, 15);
    assertThat(course.channel())
        .allSatisfy(
            gate -> {
              Point across = gate.right().minus(gate.left());
              assertThat(across.distance()).isBetween(1.83, 3.05); // 6 to 10 ft
            });
    assertThat(course.weather().windMps()).isLessThanOrEqualTo(6.0);
    assertThat(Math.hypot(course.weather().currentEastMps(), course.weather().currentNorthMps()))
        .isLessThanOrEqualTo(0.5);
  }

  @Property
  void course_sameSeed_isTheSame(@ForAll int seed) {
    assertThat(BoatCourseGenerator.course(seed)).isEqualTo(BoatCourseGenerator.course(seed));
  }

  @Property
  void course_anySeed_hasRoomAroundItsTasks(@ForAll int seed) {
    BoatCourse course = BoatCourseGenerator.course(seed);

    assertThat(course.sites()).hasSize(4);
    for (TaskSite site : course.sites()) {
      assertThat(course.channel())
          .allMatch(gate -> site.station().minus(gate.middle()).distance() > 8.0);
      assertThat(course.sites())
          .allMatch(
              other -> other == site || other.station().minus(site.station()).distance() > 10.0);
    }
  }
}
