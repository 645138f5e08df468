package org.u2sa.planning.guidance;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.planning.guidance.LineSettings.AltitudeProfile;

/** A boat that moves where it points, at 1 m/s, in a current to the east. */
class IntegralLineOfSightTest {
  private static final double STEP_S = 0.2;
  private static final LineSettings SETTINGS =
      new LineSettings(4.0, 1.0, new TurnAnticipation(0.0, 0.0, 0.5), AltitudeProfile.IMMEDIATE);

  /** Distance east of a line to the north after some time [m]. */
  private static double offAfter(GuidanceLaw law, double currentMps, double seconds) {
    LineGuidance guidance = new LineGuidance(() -> SETTINGS, law);
    Place start = Place.of(at(0.0, 0.0, 0.0, 0));
    Place end = Place.of(at(1000.0, 0.0, 0.0, 0));
    guidance.begin(Optional.of(start));
    double north = 0.0;
    double east = 0.0;
    double heading = 0.0;
    for (int i = 0; i * STEP_S < seconds; i++) {
      StateInformation state = at(north, east, heading, i);
      state.xDot(Math.cos(heading)).yDot(Math.sin(heading) + currentMps);
      Vehicle boat = Vehicle.of(state).orElseThrow();
      Point body = guidance.towards(boat, end, 1.0, Optional.empty());
      double wanted = heading - Math.atan2(body.y(), body.x()); // BODY: y is to the left
      heading += 0.5 * Math.IEEEremainder(wanted - heading, 2.0 * Math.PI);
      north += STEP_S * Math.cos(heading);
      east += STEP_S * (Math.sin(heading) + currentMps);
    }
    return east;
  }

  private static StateInformation at(double north, double east, double heading, int step) {
    StateInformation state =
        new StateInformation()
            .referenceFrame(ReferenceFrame.LOCAL_NED)
            .x(north)
            .y(east)
            .xDot(0.0)
            .yDot(0.0)
            .psi(heading);
    state.timestamp(Math.round(step * STEP_S * 1e6));
    return state;
  }

  @Test
  void towards_inACurrent_returnsToTheLineThatACarrotStaysOff() {
    assertThat(offAfter(GuidanceLaw.carrot(), 0.3, 300.0)).isGreaterThan(1.0);
    assertThat(offAfter(new IntegralLineOfSight(() -> 0.1), 0.3, 300.0)).isBetween(-0.05, 0.05);
    assertThat(offAfter(new IntegralLineOfSight(() -> 0.1), -0.5, 300.0)).isBetween(-0.1, 0.1);
  }

  @Test
  void towards_withoutIntegralGain_isPlainLineOfSight() {
    assertThat(offAfter(new IntegralLineOfSight(() -> 0.0), 0.3, 300.0)).isGreaterThan(1.0);
  }

  @Test
  void towards_mooredBesideTheLine_learnsNothing() {
    LineGuidance guidance = new LineGuidance(() -> SETTINGS, new IntegralLineOfSight(() -> 0.1));
    Place end = Place.of(at(1000.0, 0.0, 0.0, 0));
    guidance.begin(Optional.of(Place.of(at(0.0, 0.0, 0.0, 0))));
    Vehicle boat = Vehicle.of(at(10.0, 2.0, 0.0, 0)).orElseThrow();
    Point first = guidance.towards(boat, end, 1.0, Optional.empty());
    Point last = first;
    for (int i = 1; i < 3000; i++) {
      boat = Vehicle.of(at(10.0, 2.0, 0.0, i)).orElseThrow();
      last = guidance.towards(boat, end, 1.0, Optional.empty());
    }

    assertThat(last).isEqualTo(first);
  }

  @Test
  void begin_anotherLine_dropsTheIntegral() {
    IntegralLineOfSight law = new IntegralLineOfSight(() -> 0.1);
    Leg leg = new Leg(0.0, -2.0, 100.0, -2.0);
    Point before = law.pointAhead(leg, 4.0);
    law.advance(leg, 4.0, 10.0);
    assertThat(law.pointAhead(leg, 4.0)).isNotEqualTo(before);

    law.begin();

    assertThat(law.pointAhead(leg, 4.0)).isEqualTo(before);
  }
}
