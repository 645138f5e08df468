package org.u2sa.messages.shape;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Assume;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;

/** Distances to polygons and bands as the JTS Topology Suite, which nobody here wrote, has them. */
class PlanarShapeProperties {
  private static final GeometryFactory JTS = new GeometryFactory();
  private static final Geodetic PLACE = new Geodetic(-157.9, 21.3, 0.0);

  @Provide
  Arbitrary<List<Point>> corners() {
    return points().list().ofMinSize(3).ofMaxSize(9);
  }

  @Provide
  Arbitrary<Point> points() {
    Arbitrary<Double> coordinate = Arbitraries.doubles().between(-50.0, 50.0).ofScale(2);
    return Combinators.combine(coordinate, coordinate, coordinate).as(Point::of);
  }

  private static Coordinate[] coordinates(List<Point> points, boolean closed) {
    List<Coordinate> all = new ArrayList<>();
    points.forEach(point -> all.add(new Coordinate(point.x(), point.y())));
    if (closed) {
      all.add(all.get(0).copy());
    }
    return all.toArray(new Coordinate[0]);
  }

  private static double planar(Geometry geometry, Point from) {
    return geometry.distance(JTS.createPoint(new Coordinate(from.x(), from.y())));
  }

  @Property(tries = 2_000)
  void distanceTo_simplePolygon_isThatOfJts(
      @ForAll("corners") List<Point> corners, @ForAll("points") Point from) {
    Geometry area = JTS.createPolygon(coordinates(corners, true));
    Assume.that(area.isValid());
    Polygon polygon = new Polygon().points(corners).height(10.0);
    polygon.uid("p").referenceFrame(ReferenceFrame.LOCAL_NED).x(3.0).y(-4.0).z(5.0);

    double above = Math.max(0.0, Math.abs(from.z() - 5.0) - 5.0);
    assertThat(polygon.distanceTo(from))
        .isCloseTo(Math.hypot(planar(area, from), above), within(1e-9));
  }

  @Property(tries = 500)
  void distanceTo_bandAlongALine_isThatOfJts(
      @ForAll("corners") List<Point> points, @ForAll("points") Point from) {
    Geometry line = JTS.createLineString(coordinates(points, false));
    PolyLine band = new PolyLine().points(points).width(3.0);
    band.uid("p").referenceFrame(ReferenceFrame.LOCAL_NED).x(3.0).y(-4.0);

    double outside = Math.max(0.0, planar(line, from) - 1.5);
    assertThat(band.distanceTo(from)).isCloseTo(Math.hypot(outside, from.z()), within(1e-9));
  }

  @Property(tries = 100)
  void distanceTo_polygonInDegrees_isThatInMetres(
      @ForAll("corners") List<Point> corners, @ForAll("points") Point from) {
    List<Point> places = new ArrayList<>();
    corners.forEach(corner -> places.add(PLACE.fromEnu(corner).point()));
    Polygon plane = new Polygon().points(corners);
    plane.uid("p").referenceFrame(ReferenceFrame.LOCAL_ENU).x(0.0).y(0.0);
    Polygon earth = new Polygon().points(places);
    earth.uid("p").x(PLACE.point().x()).y(PLACE.point().y());

    assertThat(earth.distanceTo(PLACE.fromEnu(from).point()))
        .isCloseTo(plane.distanceTo(from), within(1e-5));
  }

  @Property(tries = 200)
  void centerAfter_alongATrajectory_isOnTheLineOfJts(
      @ForAll("corners") List<Point> way, @ForAll("points") Point start) {
    MovingSphere traffic = new MovingSphere().trajectory(way).timeStep(2.0).radius(1.0);
    traffic
        .uid("t")
        .referenceFrame(ReferenceFrame.LOCAL_NED)
        .x(start.x())
        .y(start.y())
        .z(start.z());
    List<Point> all = new ArrayList<>(List.of(start));
    all.addAll(way);
    Geometry line = JTS.createLineString(coordinates(all, false));

    for (double t = 0.0; t <= 2.0 * way.size(); t += 0.37) {
      assertThat(planar(line, traffic.centerAfter(t))).isCloseTo(0.0, within(1e-9));
    }
    Point last = way.get(way.size() - 1);
    assertThat(traffic.centerAfter(2.0 * way.size()).distanceTo(last)).isLessThan(1e-9);
  }
}
