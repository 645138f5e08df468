package org.u2sa.mission;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.safety.FenceState;
import org.u2sa.messages.shape.Polygon;

/** A square between the vehicle, 60 m east of home, and home. */
class ReturnWayTest {
  private static final Geodetic HOME = new Geodetic(179.9998, 54.0, 0.0); // square: date line
  private static final double MARGIN_M = 3.0;

  private final ReturnWay way = new ReturnWay();

  private static Point at(ReferenceFrame frame, double east, double north) {
    Point enu = Point.of(east, north, 0.0);
    return frame.isEarth() ? HOME.fromEnu(enu).point() : enu;
  }

  private static Polygon square(ReferenceFrame frame) {
    Polygon square = new Polygon();
    square.uid("keep-out 1").referenceFrame(frame);
    return square.points(
        List.of(
            at(frame, 20.0, -8.0),
            at(frame, 40.0, -8.0),
            at(frame, 40.0, 20.0),
            at(frame, 20.0, 20.0)));
  }

  private List<Waypoint> fromTheEast(ReferenceFrame frame, ReferenceFrame own) {
    way.see(new FenceState().margin(MARGIN_M).keepOut(List.of(square(frame))));
    Point from = at(own, 60.0, 0.0);
    Point to = at(own, 0.0, 0.0);
    Waypoint home = new Waypoint().uid("home").x(to.x()).y(to.y()).horizontalThreshold(1.0);
    home.referenceFrame(own);
    return way.between(new StateInformation().referenceFrame(own).x(from.x()).y(from.y()), home);
  }

  @Test
  void between_keepOutAreaInTheWayOnTheEarth_leadsRoundItWithTheMargin() {
    List<Waypoint> corners = fromTheEast(ReferenceFrame.GLOBAL, ReferenceFrame.GLOBAL);

    assertThat(corners).extracting(Waypoint::uid).containsExactly("way 1", "way 2");
    for (int i = 0; i < 2; i++) {
      Waypoint corner = corners.get(i);
      Point enu = HOME.enuOf(new Geodetic(corner.x().orElseThrow(), corner.y().orElseThrow(), 0.0));
      assertThat(enu.x()).isCloseTo(i == 0 ? 40.0 + MARGIN_M : 20.0 - MARGIN_M, within(0.1));
      assertThat(enu.y()).isCloseTo(-8.0 - MARGIN_M, within(0.1));
      assertThat(corner.horizontalThreshold()).isEqualTo(1.0);
    }
  }

  @Test
  void between_localFrames_isInThatOfTheFence() {
    assertThat(fromTheEast(ReferenceFrame.LOCAL_ENU, ReferenceFrame.LOCAL_ENU))
        .hasSize(2)
        .allSatisfy(c -> assertThat(c.referenceFrame()).isEqualTo(ReferenceFrame.LOCAL_ENU));
  }

  @Test
  void between_withoutAFenceOrInFramesThatCannotBeCompared_isStraight() {
    assertThat(fromTheEast(ReferenceFrame.GLOBAL, ReferenceFrame.LOCAL_ENU)).isEmpty();
    way.see(new FenceState());
    assertThat(way.between(new StateInformation().x(0.0).y(0.0), new Waypoint().x(1.0).y(1.0)))
        .isEmpty();
  }
}
