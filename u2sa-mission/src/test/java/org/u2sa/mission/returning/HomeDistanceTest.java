package org.u2sa.mission.returning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.Waypoint;

/** A home in San Diego. */
class HomeDistanceTest {
  private static final Optional<Waypoint> HOME =
      Optional.of(new Waypoint().uid("home").x(-117.25).y(32.7));

  private final HomeDistance distance = new HomeDistance();

  private Optional<String> at(double longitude, double latitude) {
    return distance.check(new StateInformation().x(longitude).y(latitude), HOME);
  }

  @Test
  void check_stateOfAnotherContinent_namesBothPlacesOnce() {
    assertThat(distance.check(new StateInformation().z(5.0), HOME)).isEmpty();
    assertThat(at(10.0, 54.0).orElseThrow())
        .contains("10.000000, 54.000000 deg")
        .contains("-117.250000, 32.700000 deg")
        .contains(" 9149 km ");
    assertThat(at(10.0, 54.0)).isEmpty();
  }

  @Test
  void check_stateNearTheHome_isEmptyInEachFrame() {
    assertThat(at(-117.3, 32.8)).isEmpty();
    Waypoint utm = new Waypoint().uid("home").x(476_570.0).y(3_618_000.0);
    utm.referenceFrame(ReferenceFrame.utm(11, true));
    assertThat(new HomeDistance().check(new StateInformation().x(-117.3).y(32.8), Optional.of(utm)))
        .isEmpty();
    Waypoint local = new Waypoint().uid("home").x(0.0).y(0.0);
    local.referenceFrame(ReferenceFrame.LOCAL_ENU);
    assertThat(new HomeDistance().check(new StateInformation().x(10.0).y(54.0), Optional.of(local)))
        .isEmpty();
  }

  @Test
  void check_missionWithoutHome_isEmpty() {
    assertThat(distance.check(new StateInformation().x(10.0).y(54.0), Optional.<Waypoint>empty()))
        .isEmpty();
  }
}
