package org.u2sa.mission.returning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.Waypoint;

/** A home in San Diego. */
class HomeCheckTest {
  private static final Optional<Waypoint> HOME =
      Optional.of(new Waypoint().uid("home").x(-117.25).y(32.7));

  private final HomeCheck check = new HomeCheck();
  private boolean isDisarmed;

  private Optional<String> at(double longitude, double latitude) {
    return check.distance(new StateInformation().x(longitude).y(latitude), HOME);
  }

  @Test
  void distance_stateOfAnotherContinent_namesBothPlacesOnce() {
    assertThat(check.distance(new StateInformation().z(5.0), HOME)).isEmpty();
    assertThat(at(10.0, 54.0).orElseThrow())
        .contains("10.000000, 54.000000 deg")
        .contains("-117.250000, 32.700000 deg")
        .contains(" 9149 km ");
    assertThat(at(10.0, 54.0)).isEmpty();
  }

  @Test
  void distance_stateNearTheHome_isEmptyInEachFrame() {
    assertThat(at(-117.3, 32.8)).isEmpty();
    Waypoint utm = new Waypoint().uid("home").x(476_570.0).y(3_618_000.0);
    utm.referenceFrame(ReferenceFrame.utm(11, true));
    assertThat(new HomeCheck().distance(new StateInformation().x(-117.3).y(32.8), Optional.of(utm)))
        .isEmpty();
    Waypoint local = new Waypoint().uid("home").x(0.0).y(0.0);
    local.referenceFrame(ReferenceFrame.LOCAL_ENU);
    assertThat(new HomeCheck().distance(new StateInformation().x(10.0).y(54.0), Optional.of(local)))
        .isEmpty();
  }

  @Test
  void distance_missionWithoutHome_isEmpty() {
    assertThat(check.distance(new StateInformation().x(10.0).y(54.0), Optional.<Waypoint>empty()))
        .isEmpty();
  }

  /** Altitude of a vehicle 9 m west of a home at 12 m. */
  private Optional<String> altitude(double seconds, double z, double sigma, double mps) {
    StateInformation state = new StateInformation().x(-117.2501).y(32.7).z(z).zSigma(sigma);
    state.zDot(mps).timestamp((long) (seconds * 1e6));
    return check.altitude(state, Optional.of(new Geodetic(-117.25, 32.7, 12.0)), isDisarmed);
  }

  @Test
  void altitude_higherThanHome_namesBothOnce() {
    assertThat(altitude(0.0, 27.4, 6.0, 0.0)).isEmpty();
    assertThat(altitude(1.0, 27.4, 2.5, 0.0).orElseThrow())
        .contains("at 27.4 m (sigma 2.5 m) instead of 12.0 m");
    assertThat(altitude(1.1, 27.4, 2.5, 0.0)).isEmpty();
  }

  @Test
  void altitude_plausibleOrUncertainOrFast_isEmpty() {
    assertThat(altitude(0.0, 16.9, 0.02, 0.0)).isEmpty(); // read off a map
    assertThat(altitude(0.1, 27.4, 6.0, 0.0)).isEmpty();
    assertThat(altitude(0.2, 112.0, 10.5, 0.0)).isEmpty();
    assertThat(altitude(0.3, 27.4, 2.5, -3.5)).isEmpty();
    assertThat(altitude(0.4, -3.0, 2.5, 0.0)).isPresent();
  }

  @Test
  void altitude_later_isComparedOnlyOfADisarmedVehicle() {
    assertThat(altitude(0.0, 12.0, 2.5, 0.0)).isEmpty();
    assertThat(altitude(60.0, 40.0, 2.5, 0.0)).isEmpty(); // may hover there
    isDisarmed = true;
    assertThat(altitude(61.0, 40.0, 2.5, 0.0)).isPresent();
  }

  @Test
  void altitude_farFromHome_isEmpty() {
    StateInformation far = new StateInformation().x(-117.251).y(32.7).z(40.0).zSigma(1.0);
    assertThat(check.altitude(far, Optional.of(new Geodetic(-117.25, 32.7, 12.0)), true)).isEmpty();
  }
}
