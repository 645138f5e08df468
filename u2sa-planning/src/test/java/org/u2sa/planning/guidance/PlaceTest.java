package org.u2sa.planning.guidance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.TakeOff;
import org.u2sa.messages.goal.Waypoint;

class PlaceTest {
  private static final ReferenceFrame UTM = ReferenceFrame.utm(18, true);

  @Test
  void of_altitudeOfATakeOffInUtm_isThatAboveTheSea() {
    Waypoint takeOff = new TakeOff().referenceFrame(UTM).z(63.0);

    Place place = Place.of(takeOff);
    assertThat(place.onEarth()).isTrue();
    assertThat(place.isHorizontal()).isFalse();
    assertThat(place.upM()).hasValue(63.0);
  }

  @Test
  void of_eastingWithoutNorthing_isRefused() {
    Waypoint half = new Waypoint().referenceFrame(UTM).x(500_000.0);

    assertThatThrownBy(() -> Place.of(half))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("a position in UTM 18N with x or y alone");
  }
}
