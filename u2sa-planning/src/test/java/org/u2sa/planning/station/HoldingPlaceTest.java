package org.u2sa.planning.station;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.OptionalDouble;
import java.util.function.Predicate;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.guidance.Vehicle;

/** An aeroplane on its way north, 50 m up, on a local plane; circles of 100 m. */
class HoldingPlaceTest {
  private static final Predicate<Place> EVERYWHERE = place -> true;
  private static final Place HERE = place(0.0, 0.0, 50.0);

  private static Place place(double north, double east, double upM) {
    return new Place(
        false, OptionalDouble.of(east), OptionalDouble.of(north), OptionalDouble.of(upM));
  }

  private static Place near(Predicate<Place> isClosed, Predicate<Place> isInside, boolean aside) {
    StateInformation state =
        new StateInformation().referenceFrame(ReferenceFrame.LOCAL_NED).x(0.0).y(0.0).z(-50.0);
    state.xDot(20.0).yDot(0.0).psi(0.0).timestamp(0L);
    return new HoldingPlace(100.0, isClosed, isInside)
        .near(HERE, aside, Vehicle.of(state).orElseThrow());
  }

  private static double north(Place place) {
    return place.y().orElseThrow();
  }

  private static double east(Place place) {
    return place.x().orElseThrow();
  }

  private static double up(Place place) {
    return place.upM().orElseThrow();
  }

  @Test
  void near_nothingClosed_isHere() {
    assertThat(near(place -> false, EVERYWHERE, true)).isEqualTo(HERE);
  }

  @Test
  void near_closedAhead_isToTheRight() {
    Place centre =
        near(place -> north(place) > 90.0 && Math.abs(east(place)) < 50.0, EVERYWHERE, true);

    assertThat(east(centre)).isEqualTo(100.0);
    assertThat(up(centre)).isEqualTo(50.0);
  }

  @Test
  void near_closedAheadAndToTheRight_isToTheLeft() {
    assertThat(east(near(place -> north(place) > 90.0 && east(place) > -50.0, EVERYWHERE, true)))
        .isEqualTo(-100.0);
  }

  @Test
  void near_lowClosed_isAbove() {
    Place centre = near(place -> up(place) < 80.0, EVERYWHERE, true);

    assertThat(up(centre)).isEqualTo(100.0);
    assertThat(east(centre)).isZero();
  }

  @Test
  void near_lowClosedBelowACeiling_isWhereTheLeastIsClosed() {
    Predicate<Place> isClosed = place -> up(place) < 80.0 && east(place) < 50.0;
    Place centre = near(isClosed, place -> up(place) < 90.0, true);

    assertThat(up(centre)).isEqualTo(50.0);
    assertThat(east(centre)).isEqualTo(100.0);
  }

  @Test
  void near_givenPlaceClosed_isAboveItRatherThanBeside() {
    Place centre = near(place -> north(place) > 90.0 && up(place) < 60.0, EVERYWHERE, false);

    assertThat(east(centre)).isZero();
    assertThat(up(centre)).isEqualTo(75.0);
  }
}
