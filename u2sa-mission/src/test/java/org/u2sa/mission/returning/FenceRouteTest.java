package org.u2sa.mission.returning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Envelope;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.io.ParseException;
import org.locationtech.jts.io.WKTReader;

class FenceRouteTest {
  private static final GeometryFactory FACTORY = new GeometryFactory();
  private static final Geometry FIELD =
      FACTORY.toGeometry(new Envelope(-200.0, 200.0, -200.0, 200.0));
  private static final double DISTANCE_M = 2.0;

  private static Geometry wkt(String text) throws ParseException {
    return new WKTReader().read(text);
  }

  private static Optional<List<Coordinate>> route(Geometry allowed, double x, double y) {
    return new FenceRoute(allowed, 0.0, DISTANCE_M)
        .between(new Coordinate(0.0, 0.0), new Coordinate(x, y));
  }

  private static Geometry line(List<Coordinate> corners, double x, double y) {
    List<Coordinate> all = new ArrayList<>(corners);
    all.add(0, new Coordinate(0.0, 0.0));
    all.add(new Coordinate(x, y));
    return FACTORY.createLineString(all.toArray(new Coordinate[0]));
  }

  @Test
  void between_straightWayFree_hasNoCorners() throws ParseException {
    Geometry allowed = FIELD.difference(wkt("POLYGON ((10 -5, 20 -5, 20 5, 10 5, 10 -5))"));

    assertThat(route(allowed, 0.0, 50.0).orElseThrow()).isEmpty();
  }

  @Test
  void between_squareInTheWay_leadsRoundTheNearerSideAtItsDistance() throws ParseException {
    Geometry square = wkt("POLYGON ((10 -5, 20 -5, 20 9, 10 9, 10 -5))");

    List<Coordinate> corners = route(FIELD.difference(square), 30.0, 0.0).orElseThrow();

    assertThat(corners).hasSize(2).allSatisfy(c -> assertThat(c.y).isCloseTo(-7.0, within(1e-6)));
    assertThat(line(corners, 30.0, 0.0).distance(square)).isCloseTo(DISTANCE_M, within(0.3));
  }

  @Test
  void between_concaveKeepInArea_leadsRoundItsReflexCorner() throws ParseException {
    Geometry ell = wkt("POLYGON ((-10 -10, 60 -10, 60 60, 40 60, 40 10, -10 10, -10 -10))");

    List<Coordinate> corners = route(ell, 50.0, 50.0).orElseThrow();

    assertThat(corners).isNotEmpty();
    assertThat(ell.buffer(-0.9 * DISTANCE_M).covers(line(corners, 50.0, 50.0))).isTrue();
  }

  @Test
  void between_startWithinAForbiddenArea_leavesItByTheNearestSide() throws ParseException {
    Geometry allowed = FIELD.difference(wkt("POLYGON ((-30 -3, 4 -3, 4 20, -30 20, -30 -3))"));

    List<Coordinate> corners = route(allowed, 50.0, 0.0).orElseThrow();

    assertThat(corners.get(0).distance(new Coordinate(0.0, -5.0))).isLessThan(0.1);
  }

  @Test
  void between_endNearerToABorderThanTheDistance_leadsToItByTheNearestFreePoint()
      throws ParseException {
    Geometry field = wkt("POLYGON ((-10 -100, 31 -100, 31 100, -10 100, -10 -100))");
    Geometry square = wkt("POLYGON ((10 -5, 20 -5, 20 9, 10 9, 10 -5))");
    Geometry allowed = field.difference(square);

    List<Coordinate> corners = route(allowed, 30.0, 0.0).orElseThrow();

    assertThat(corners).hasSize(3);
    assertThat(line(corners, 30.0, 0.0).distance(square)).isGreaterThan(1.7);
    assertThat(corners.get(2).distance(new Coordinate(29.0, 0.0))).isLessThan(0.1);
  }

  @Test
  void between_alongABorderNearerThanTheDistance_isStraight() throws ParseException {
    Geometry field = wkt("POLYGON ((-10 -1, 100 -1, 100 50, -10 50, -10 -1))");

    assertThat(route(field, 30.0, 0.0).orElseThrow()).isEmpty();
  }

  @Test
  void between_moreCornersThanCanBeSearched_leadsRoundThemAtAGreaterDistance() {
    Geometry allowed = FIELD;
    for (int i = 0; i < 40; i++) {
      Coordinate centre = new Coordinate(20.0 + 20.0 * (i % 8), -40.0 + 20.0 * (i / 8));
      allowed = allowed.difference(FACTORY.createPoint(centre).buffer(6.0, 16));
    }

    List<Coordinate> corners = route(allowed, 190.0, 0.0).orElseThrow();

    assertThat(corners).isNotEmpty();
    assertThat(line(corners, 190.0, 0.0).distance(allowed.getBoundary())).isGreaterThan(1.7);
  }

  /** The free area is nearer through the wall than by the pocket's mouth. */
  @Test
  void between_startInAPocketTooNarrowForTheDistance_isNoWayThroughItsWall() throws ParseException {
    Geometry pocket =
        wkt("POLYGON ((-1.5 -20, -1 -20, -1 3, 1 3, 1 -20, 1.5 -20, 1.5 3.5, -1.5 3.5, -1.5 -20))");

    assertThat(route(FIELD.difference(pocket), 0.0, 40.0)).isEmpty();
    List<Coordinate> corners =
        new FenceRoute(FIELD.difference(pocket), 0.0, 0.2)
            .between(new Coordinate(0.0, 0.0), new Coordinate(0.0, 40.0))
            .orElseThrow();
    assertThat(line(corners, 0.0, 40.0).distance(pocket)).isGreaterThan(0.15);
  }

  @Test
  void between_behindAClosedArea_isEmpty() throws ParseException {
    Geometry wall = wkt("POLYGON ((10 -300, 20 -300, 20 300, 10 300, 10 -300))");

    assertThat(route(FIELD.difference(wall), 30.0, 0.0)).isEmpty();
  }

  /** Between two walls, beyond the margin of one of which the free area is nearest. */
  @Test
  void between_startWithinTheMarginOfAWall_leadsAroundItsEnd() throws ParseException {
    Geometry walls =
        wkt(
            "MULTIPOLYGON (((9 -30, 10 -30, 10 30, 9 30, 9 -30)), ((-8 -30, -7 -30, -7 30, -8 30, -8 -30)))");
    Geometry allowed = FIELD.difference(walls.buffer(3.0));

    List<Coordinate> corners =
        new FenceRoute(allowed, 3.0, 6.0)
            .between(new Coordinate(8.0, 0.0), new Coordinate(30.0, 0.0))
            .orElseThrow();

    corners.add(0, new Coordinate(8.0, 0.0));
    assertThat(FACTORY.createLineString(corners.toArray(new Coordinate[0])).intersects(walls))
        .isFalse();
  }
}
