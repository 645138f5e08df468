package org.u2sa.mission.returning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Envelope;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.operation.overlayng.OverlayNG;
import org.locationtech.jts.operation.overlayng.OverlayNGRobust;
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
    return way.between(new StateInformation().referenceFrame(own).x(from.x()).y(from.y()), home)
        .orElseThrow();
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

  /** A passage of 3 m, where twice the margin is 6 m, in a wall across the field. */
  @Test
  void between_passageNarrowerThanTheDistance_isUsed() {
    ReferenceFrame frame = ReferenceFrame.LOCAL_ENU;
    Polygon field = new Polygon().points(box(-20.0, -50.0, 80.0, 50.0));
    Polygon upper = new Polygon().points(box(30.0, 20.0, 34.0, 60.0));
    Polygon lower = new Polygon().points(box(30.0, -60.0, 34.0, 17.0));
    List.of(field, upper, lower).forEach(each -> each.uid("area").referenceFrame(frame));
    way.see(
        new FenceState().margin(MARGIN_M).keepIn(List.of(field)).keepOut(List.of(upper, lower)));
    Waypoint home = new Waypoint().uid("home").x(0.0).y(0.0).horizontalThreshold(1.0);
    home.referenceFrame(frame);

    List<Waypoint> corners =
        way.between(new StateInformation().referenceFrame(frame).x(60.0).y(0.0), home)
            .orElseThrow();

    assertThat(corners)
        .isNotEmpty()
        .allSatisfy(c -> assertThat(c.y().orElseThrow()).isBetween(17.2, 19.8));
  }

  @Test
  void between_placeInAForbiddenArea_isNoWay() {
    ReferenceFrame frame = ReferenceFrame.LOCAL_ENU;
    Polygon around = new Polygon().points(box(-5.0, -5.0, 5.0, 5.0));
    around.uid("area").referenceFrame(frame);
    way.see(new FenceState().keepOut(List.of(around)));
    Waypoint home = new Waypoint().uid("home").x(0.0).y(0.0).horizontalThreshold(1.0);
    home.referenceFrame(frame);

    assertThat(way.between(new StateInformation().referenceFrame(frame).x(60.0).y(0.0), home))
        .isEmpty();
  }

  @Test
  void between_hundredsOfAreas_leadsRoundThem() {
    ReferenceFrame frame = ReferenceFrame.LOCAL_ENU;
    List<Polygon> areas = new ArrayList<>();
    for (int i = 0; i < 390; i++) {
      double east = 20.0 + 4.0 * (i % 30);
      double north = 4.0 * (i / 30) - 26.0;
      Polygon area = new Polygon().points(box(east, north, east + 1.0, north + 1.0));
      area.uid("area").referenceFrame(frame);
      areas.add(area);
    }
    way.see(new FenceState().keepOut(areas));
    Waypoint home = new Waypoint().uid("home").x(0.0).y(0.5).horizontalThreshold(0.5);
    home.referenceFrame(frame);

    assertThat(way.between(new StateInformation().referenceFrame(frame).x(160.0).y(0.5), home))
        .isPresent();
  }

  /** Quadrangles on a coarse raster, so that corners and borders often coincide or nearly do. */
  @Test
  void between_randomFences_wayStaysWhereItMay() {
    Random random = new Random(8L);
    GeometryFactory factory = new GeometryFactory();
    int ways = 0;
    for (int i = 0; i < 300; i++) {
      List<Polygon> areas = new ArrayList<>();
      Geometry allowed = factory.toGeometry(new Envelope(-1000.0, 1000.0, -1000.0, 1000.0));
      for (int k = 0; k < 1 + random.nextInt(8); k++) {
        List<Point> corners = new ArrayList<>();
        double east = 10.0 * random.nextInt(10);
        double north = 10.0 * random.nextInt(10) - 50.0;
        for (int c = 0; c < 4; c++) {
          double nearly = random.nextBoolean() ? 0.0 : 1e-9 * random.nextGaussian();
          corners.add(
              Point.of(
                  east + nearly + (c == 1 || c == 2 ? 10.0 * (1 + random.nextInt(2)) : 0.0),
                  north + nearly + (c > 1 ? 10.0 * (1 + random.nextInt(3)) : 0.0),
                  0.0));
        }
        Polygon area = new Polygon().points(corners);
        area.uid("area").referenceFrame(ReferenceFrame.LOCAL_ENU);
        areas.add(area);
        List<Coordinate> ring = new ArrayList<>();
        corners.forEach(corner -> ring.add(new Coordinate(corner.x(), corner.y())));
        ring.add(ring.get(0));
        allowed =
            OverlayNGRobust.overlay(
                allowed,
                factory.createPolygon(ring.toArray(new Coordinate[0])).buffer(-1e-3),
                OverlayNG.DIFFERENCE);
      }
      way.see(new FenceState().margin(random.nextInt(6)).keepOut(areas));
      Coordinate from =
          new Coordinate(110.0 * random.nextDouble(), 100.0 * random.nextDouble() - 50.0);
      Waypoint home = new Waypoint().uid("home").x(-10.0).y(0.0).horizontalThreshold(0.5);
      home.referenceFrame(ReferenceFrame.LOCAL_ENU);
      StateInformation state = new StateInformation().referenceFrame(ReferenceFrame.LOCAL_ENU);
      Optional<List<Waypoint>> found = way.between(state.x(from.x).y(from.y), home);
      if (found.isPresent() && allowed.covers(factory.createPoint(from))) {
        List<Coordinate> line = new ArrayList<>(List.of(from));
        found
            .get()
            .forEach(c -> line.add(new Coordinate(c.x().orElseThrow(), c.y().orElseThrow())));
        line.add(new Coordinate(-10.0, 0.0));
        assertThat(allowed.covers(factory.createLineString(line.toArray(new Coordinate[0]))))
            .as("fence %d from %s", i, from)
            .isTrue();
        ways++;
      }
    }
    assertThat(ways).isGreaterThan(150);
  }

  private static List<Point> box(double west, double south, double east, double north) {
    return List.of(
        Point.of(west, south, 0.0),
        Point.of(east, south, 0.0),
        Point.of(east, north, 0.0),
        Point.of(west, north, 0.0));
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
        .hasValue(List.of());
  }
}
