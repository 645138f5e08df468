package org.u2sa.planning.payload;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.guidance.Vehicle;

/** On a local plane, of which ground is too high in some directions from the aim. */
class RunInTest {
  private static final Place AIM =
      new Place(false, OptionalDouble.of(0.0), OptionalDouble.of(0.0), OptionalDouble.of(50.0));

  /** Course on the run-in when ground within 40° of a bearing from the aim is too high [deg]. */
  private static double courseDeg(double wantedDeg, double groundDeg) {
    Optional<RunIn> way =
        RunIn.to(
            AIM,
            Math.toRadians(wantedDeg),
            100.0,
            place -> {
              double bearing = Math.atan2(place.x().getAsDouble(), place.y().getAsDouble());
              return Math.cos(bearing - Math.toRadians(groundDeg)) > Math.cos(Math.toRadians(40.0));
            },
            0);
    return Math.toDegrees(way.orElseThrow().courseRad());
  }

  @ParameterizedTest
  @CsvSource({"0, 90, 0", "90, 0, 90", "0, 0, -45", "0, 180, -45", "30, 40, -15", "90, -80, 45"})
  void to_groundBeforeOrBehind_isTheNearestFreeCourse(
      double wantedDeg, double groundDeg, double courseDeg) {
    assertThat(courseDeg(wantedDeg, groundDeg)).isCloseTo(courseDeg, within(1e-9));
  }

  @ParameterizedTest
  @CsvSource({"0, 0", "1, -45", "2, 45", "7, -180"})
  void to_someTriedBefore_isTheNextOne(int skipped, double courseDeg) {
    RunIn way = RunIn.to(AIM, 0.0, 100.0, place -> false, skipped).orElseThrow();

    assertThat(Math.toDegrees(way.courseRad())).isCloseTo(courseDeg, within(1e-9));
    assertThat(RunIn.to(AIM, 0.0, 100.0, place -> false, 8)).isEmpty();
  }

  @Test
  void to_groundAllAround_isNone() {
    assertThat(RunIn.to(AIM, 0.0, 100.0, place -> true, 0)).isEmpty();
  }

  @ParameterizedTest
  @CsvSource({"-100, 0, 0, true", "-80, 10, 20, true", "-70, 0, 0, false", "-100, 0, 40, false"})
  void isReached_placeAndCourse_bothMatter(
      double north, double east, double courseDeg, boolean isReached) {
    StateInformation state =
        new StateInformation().referenceFrame(ReferenceFrame.LOCAL_NED).x(north).y(east).z(-50.0);
    double course = Math.toRadians(courseDeg);
    state.xDot(20.0 * Math.cos(course)).yDot(20.0 * Math.sin(course)).psi(course).timestamp(0L);
    RunIn way = RunIn.to(AIM, 0.0, 100.0, place -> false, 0).orElseThrow();

    assertThat(way.isReached(Vehicle.of(state).orElseThrow())).isEqualTo(isReached);
  }
}
