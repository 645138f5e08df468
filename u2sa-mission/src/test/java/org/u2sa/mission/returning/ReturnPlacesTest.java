package org.u2sa.mission.returning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.safety.FenceState;

/** The home at 10 deg east, a rally point 0.01 deg east of it, and the vehicle in between. */
class ReturnPlacesTest {
  private static final double THRESHOLD_M = 3.0;

  private Optional<Waypoint> home = Optional.of(place("home", 10.0));
  private final ReturnPlaces places = new ReturnPlaces(() -> home);

  private static Waypoint place(String name, double longitude) {
    return new Waypoint().uid(name).x(longitude).y(54.0).horizontalThreshold(1.0);
  }

  private void rally(Waypoint... points) {
    places.see(new FenceState().rally(List.of(points)));
  }

  private void at(double longitude) {
    places.see(new StateInformation().x(longitude).y(54.0));
  }

  private Optional<String> nearest() {
    return places.nearest(THRESHOLD_M).map(Waypoint::uid);
  }

  @Test
  void nearest_byPosition_isHomeOrTheRallyPointWithTheThreshold() {
    rally(place("rally 1", 10.1), place("rally 2", 10.01));
    at(10.004);
    assertThat(nearest()).hasValue("home");

    at(10.006);
    assertThat(nearest()).hasValue("rally 2");
    assertThat(places.nearest(THRESHOLD_M).orElseThrow().horizontalThreshold())
        .isEqualTo(THRESHOLD_M);
  }

  @Test
  void nearest_withoutAPosition_isHome() {
    rally(place("rally 1", 10.01));
    places.see(new StateInformation().z(5.0));
    assertThat(nearest()).hasValue("home");
  }

  @Test
  void nearest_inAnotherFrame_isHome() {
    rally(place("rally 1", 10.01));
    places.see(new StateInformation().referenceFrame(ReferenceFrame.LOCAL_ENU).x(0.0).y(0.0));
    assertThat(nearest()).hasValue("home");
  }

  @Test
  void nearest_withoutAHome_isTheRallyPoint() {
    home = Optional.empty();
    assertThat(nearest()).isEmpty();
    rally(place("rally 1", 10.01));
    assertThat(nearest()).hasValue("rally 1");
  }

  @Test
  void nearest_stateAndRallyPointInFramesThatNobodyCanCompare_isHome() {
    Waypoint aboard = place("rally 2", 1.0);
    aboard.referenceFrame(ReferenceFrame.BODY);
    rally(place("rally 1", 10.01), aboard);
    for (ReferenceFrame frame : List.of(ReferenceFrame.BODY, ReferenceFrame.LOCAL_NED)) {
      places.see(new StateInformation().referenceFrame(frame).x(0.0).y(0.0));
      assertThat(nearest()).as(frame.toString()).hasValue("home");
    }
  }
}
