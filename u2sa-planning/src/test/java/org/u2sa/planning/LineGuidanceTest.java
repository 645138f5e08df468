package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.planning.guidance.LineGuidance;
import org.u2sa.planning.guidance.LineSettings;
import org.u2sa.planning.guidance.LineSettings.AltitudeProfile;
import org.u2sa.planning.guidance.LoiterCircle;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.guidance.TurnAnticipation;
import org.u2sa.planning.guidance.Vehicle;

class LineGuidanceTest {
  private static final LineSettings AIRCRAFT =
      new LineSettings(
          150.0, 5.0, new TurnAnticipation(4.57, 0.0, 60.0), AltitudeProfile.IMMEDIATE);

  private static StateInformation at(double north, double east) {
    return new StateInformation()
        .referenceFrame(ReferenceFrame.LOCAL_NED)
        .x(north)
        .y(east)
        .psi(0.0)
        .xDot(46.0)
        .yDot(0.0);
  }

  private static Vehicle vehicle(double north, double east) {
    return Vehicle.of(at(north, east)).orElseThrow();
  }

  private static Place place(double north, double east) {
    return Place.of(at(north, east));
  }

  /**
   * Whether it turns right already, 250 m before a right-angled corner, so far to the right of the
   * leg.
   */
  private static boolean turnsAlready(double rightM) {
    LineGuidance guidance = new LineGuidance(() -> AIRCRAFT);
    guidance.begin(Optional.of(place(0.0, 0.0)));
    Point body =
        guidance.towards(
            vehicle(750.0, rightM), place(1000.0, 0.0), 100.0, Optional.of(place(1000.0, 1000.0)));
    return -body.y() > 150.0;
  }

  @Test
  void towards_offTheLegOutsideTheTurn_turnsSoonerThanInside() {
    assertThat(turnsAlready(-40.0)).isTrue();
    assertThat(turnsAlready(40.0)).isFalse();
  }

  @Test
  void loiter_centreToTheRight_isFlownClockwise() {
    LoiterCircle circle = new LoiterCircle(place(0.0, 500.0), 500.0, vehicle(0.0, 0.0));
    Point ahead = circle.tangentAhead(vehicle(0.0, 0.0), 100.0, 0.0);

    assertThat(ahead.x()).isBetween(95.0, 100.0); // ahead, not behind
    assertThat(ahead.y()).isBetween(5.0, 15.0);
  }

  @Test
  void loiter_centreToTheLeft_isFlownCounterClockwise() {
    LoiterCircle circle = new LoiterCircle(place(0.0, -500.0), 500.0, vehicle(0.0, 0.0));
    Point ahead = circle.tangentAhead(vehicle(0.0, 0.0), 100.0, 0.0);

    assertThat(ahead.x()).isBetween(95.0, 100.0);
    assertThat(ahead.y()).isBetween(-15.0, -5.0);
  }
}
