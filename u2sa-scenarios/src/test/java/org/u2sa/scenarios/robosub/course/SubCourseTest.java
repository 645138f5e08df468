package org.u2sa.scenarios.robosub.course;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SubCourseTest {
  @ParameterizedTest
  @ValueSource(longs = {1, 2, 77, 4711})
  void of_anySeed_isTheSameAgainAndAllObjectsAreUnderWater(long seed) {
    SubCourse course = SubCourse.of(seed);

    assertThat(SubCourse.of(seed)).isEqualTo(course);
    assertThat(course.objects()).hasSize(13).allMatch(object -> object.z() <= 0.0);
    assertThat(course.tasks().stream().flatMap(task -> task.goals().stream()))
        .extracting(CourseTask.Goal::name)
        .doesNotHaveDuplicates();
  }
}
