package org.u2sa.messages.shape;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;

/** Distance from a point to the closest point of every shape (3.2.3.5). */
class ShapesTest {
  private static <T extends ObjectDescription> T local(T object) {
    object.uid("o").referenceFrame(ReferenceFrame.LOCAL_ENU).x(10.0).y(20.0);
    return object;
  }

  private static void assertDistance(
      ObjectDescription object, double x, double y, double z, double expected) {
    assertThat(object.distanceTo(Point.of(x, y, z))).isCloseTo(expected, within(1e-9));
  }

  @Test
  void distanceTo_point_isStraight() {
    assertDistance(local(new ObjectDescription()), 13.0, 24.0, 12.0, 13.0);
  }

  @Test
  void distanceTo_roundShapes_isToTheSurfaceAndZeroInside() {
    Circle circle = local(new Circle().radius(2.0));
    assertDistance(circle, 15.0, 20.0, 0.0, 3.0);
    assertDistance(circle, 11.0, 20.0, 0.0, 0.0);
    assertDistance(circle, 11.0, 20.0, 4.0, 4.0);
    Sphere sphere = local(new Sphere().radius(2.0));
    assertDistance(sphere, 10.0, 20.0, 5.0, 3.0);
    assertDistance(sphere, 10.0, 21.0, 0.0, 0.0);
    Cylinder cylinder = local(new Cylinder().radius(2.0).height(10.0));
    assertDistance(cylinder, 10.0, 20.0, 4.0, 0.0);
    assertDistance(cylinder, 15.0, 20.0, 9.0, 5.0);
  }

  @Test
  void distanceTo_turnedRectangle_countsPsiFromXTowardsY() {
    Rectangle rectangle = local(new Rectangle().length(8.0).width(2.0).psi(Math.PI / 2.0));
    assertDistance(rectangle, 10.0, 27.0, 0.0, 3.0);
    assertDistance(rectangle, 13.0, 20.0, 0.0, 2.0);
    assertDistance(rectangle, 10.5, 23.0, 0.0, 0.0);
    Box box = local(new Box().length(8.0).width(2.0).height(2.0));
    assertDistance(box, 17.0, 20.0, 5.0, 5.0);
  }

  @Test
  void distanceTo_rectangleInGlobal_countsPsiFromNorth() {
    Geodetic center = new Geodetic(-157.9, 21.3, 0.0);
    Rectangle runway = new Rectangle().uid("r").x(-157.9).y(21.3);
    runway.length(2000.0).width(60.0).psi(0.0);

    assertThat(runway.distanceTo(center.fromEnu(Point.of(0.0, 1100.0, 0.0)).point()))
        .isCloseTo(100.0, within(0.1));
    assertThat(runway.distanceTo(center.fromEnu(Point.of(130.0, 0.0, 0.0)).point()))
        .isCloseTo(100.0, within(0.1));
  }

  @Test
  void distanceTo_cloudAndLine_isToTheNearestPart() {
    List<Point> corner = List.of(Point.of(0, 0, 0), Point.of(10, 0, 0), Point.of(10, 10, 0));
    assertDistance(local(new PointCloud().points(corner)), 5.0, 5.0, 0.0, Math.sqrt(50.0));
    assertDistance(local(new Line().points(corner)), 5.0, 4.0, 0.0, 4.0);
    assertDistance(local(new Line().points(corner)), 10.0, 13.0, 4.0, 5.0);
    assertDistance(local(new Line()), 10.0, 20.0, 7.0, 7.0);
  }

  @Test
  void polar_pointOfARangeFinder_isWhereItLooks() {
    Point point = Point.polar(Math.PI / 2.0, Math.PI / 6.0, 2.0);

    assertThat(point.distanceTo(Point.of(0.0, Math.sqrt(3.0), 1.0))).isLessThan(1e-12);
    assertThat(point.azimuth()).isCloseTo(Math.PI / 2.0, within(1e-12));
    assertThat(point.elevation()).isCloseTo(Math.PI / 6.0, within(1e-12));
    assertThat(point.distance()).isCloseTo(2.0, within(1e-12));
  }
}
