package org.u2sa.sim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.Box;
import org.u2sa.messages.shape.Circle;
import org.u2sa.messages.shape.Cylinder;
import org.u2sa.messages.shape.Line;
import org.u2sa.messages.shape.PointCloud;
import org.u2sa.messages.shape.Rectangle;
import org.u2sa.sim.atmosphere.Wind;

class WorldTest {
  private static final Geodetic HOME = new Geodetic(11.0, 48.0, 500.0);
  private static final World LAWN = World.at(HOME);
  private static final Footprint CAR = Footprint.rectangle(1.0, 1.0, 1.0, 0.0, 1.0);

  private static ObjectDescription at(ObjectDescription object, double east, double north) {
    return object.uid("it").referenceFrame(ReferenceFrame.LOCAL_ENU).x(east).y(north);
  }

  private static Ray northward(double up) {
    return new Ray(0.0, 0.0, up, 0.0, 1.0, 0.0);
  }

  @Test
  void cast_cylinderAhead_hitsItsFaceAndNamesIt() {
    ObjectDescription barrel = at(new Cylinder().radius(0.5).height(2.0), 0.0, 10.0);
    World.Hit hit = LAWN.with(List.of(barrel)).cast(northward(0.4), 30.0).orElseThrow();

    assertThat(hit.distanceM()).isEqualTo(9.5);
    assertThat(hit.at()).isEqualTo(Point.of(0.0, 9.5, 0.4));
    assertThat(hit.object()).containsSame(barrel);
  }

  @Test
  void cast_obstacleAtTheRange_isSeenAndNotBeyond() {
    World world = LAWN.with(List.of(at(new Cylinder().radius(0.5).height(2.0), 0.0, 10.0)));

    assertThat(world.cast(northward(0.4), 9.5)).isPresent();
    assertThat(world.cast(northward(0.4), 9.49)).isEmpty();
    assertThat(world.distanceM(northward(0.4), 9.49)).isInfinite();
  }

  @Test
  void cast_fromInside_isZero() {
    World world = LAWN.with(List.of(at(new Box().length(2.0).width(2.0).height(2.0), 0.0, 0.0)));

    assertThat(world.distanceM(northward(0.5), 9.0)).isZero();
  }

  @Test
  void cast_downwards_hitsTheGroundAndTheDiscOnIt() {
    Ray down = new Ray(0.0, 0.0, 3.0, 0.0, 0.0, -1.0);

    assertThat(LAWN.cast(down, 9.0).orElseThrow().object()).isEmpty();
    assertThat(LAWN.distanceM(down, 9.0)).isEqualTo(3.0);
    World marked = LAWN.with(List.of(at(new Circle().radius(1.0).z(0.5), 0.0, 0.0)));
    assertThat(marked.distanceM(down, 9.0)).isEqualTo(2.5);
  }

  @Test
  void cast_grazingAHill_meetsItsFaceNearTheTop() {
    World world = LAWN.with(Terrain.hill(0.0, 50.0, 20.0, 0.3));
    double top = world.terrain().highestM();

    assertThat(world.distanceM(northward(top + 1e-3), 90.0)).isInfinite();
    double hit = world.distanceM(northward(top - 1e-6), 90.0);
    assertThat(hit).isBetween(49.9, 50.0);
    assertThat(world.terrain().heightM(0.0, hit)).isCloseTo(top - 1e-6, within(1e-12));
  }

  @Test
  void with_objectOnTheEarth_liesWhereItsPositionIs() {
    Geodetic place = HOME.fromEnu(Point.of(0.0, 10.0, 0.0));
    ObjectDescription wall =
        new Rectangle()
            .length(4.0)
            .width(2.0)
            .psi(Math.PI / 2.0)
            .uid("wall")
            .x(place.longitudeDeg())
            .y(place.latitudeDeg())
            .z(500.5);
    World world = LAWN.with(List.of(wall));

    // Length along psi, clockwise from north: 4 m east to west, 2 m south to north.
    assertThat(world.contacts(CAR, Point.of(2.4, 10.0, 0.0), 0.0)).containsExactly(wall);
    assertThat(world.contacts(CAR, Point.of(2.6, 10.0, 0.0), 0.0)).isEmpty();
    assertThat(world.contacts(CAR, Point.of(0.0, 12.1, 0.0), 0.0)).isEmpty();
  }

  @Test
  void contacts_lineBetweenTheWheels_isTouchedAndSeenByNoRay() {
    ObjectDescription line =
        at(new Line().points(List.of(Point.of(-5, 3, 0), Point.of(5, 3, 0))), 0.0, 3.0);
    World world = LAWN.with(List.of(line));

    assertThat(world.contacts(CAR, Point.of(0.0, 2.01, 0.0), 0.0)).containsExactly(line);
    assertThat(world.contacts(CAR, Point.of(0.0, 1.99, 0.0), 0.0)).isEmpty();
    assertThat(world.distanceM(northward(0.1), 9.0)).isInfinite();
  }

  @Test
  void contacts_pointsAboveTheRoof_areNone() {
    ObjectDescription cloud =
        at(new PointCloud().points(List.of(Point.of(0, 0, 1.1), Point.of(9, 0, 0.5))), 0.0, 0.0);
    World world = LAWN.with(List.of(cloud));

    assertThat(world.contacts(CAR, Point.ORIGIN, 0.0)).isEmpty();
    assertThat(world.contacts(CAR, Point.of(9.0, 0.9, 0.0), 0.0)).containsExactly(cloud);
  }

  @Test
  void with_vehiclesOwnFrame_isRefusedByName() {
    ObjectDescription own = at(new Cylinder(), 1.0, 0.0).referenceFrame(ReferenceFrame.BODY);

    assertThatThrownBy(() -> LAWN.with(List.of(own)))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("obstacle \"it\" is in BODY: expected a frame of the world");
  }

  @Test
  void with_oneThing_leavesTheRest() {
    World world =
        LAWN.with(Wind.constant(1.0, 5.0))
            .with(new Water(-1.0, 0.3, -0.2))
            .with(Terrain.slope(0.1, 0.0))
            .with(Surface.concrete())
            .with(List.of(at(new Cylinder().radius(1.0), 3.0, 3.0)));

    assertThat(world.wind().speedMps()).isEqualTo(5.0);
    assertThat(world.water().orElseThrow().depthM(-3.0)).isEqualTo(2.0);
    assertThat(world.obstacles()).hasSize(1);
    assertThat(world.plane().at(0.0, 10.0, world.terrain().heightM(0.0, 10.0)).altitudeM())
        .isCloseTo(500.0 + 10.0 * Math.tan(0.1), within(1e-9));
    Geodetic place = world.plane().at(0.0, 10.0, world.terrain().heightM(0.0, 10.0));
    assertThat(world.elevationM(place.longitudeDeg(), place.latitudeDeg()))
        .isCloseTo(place.altitudeM(), within(1e-6));
  }

  @Test
  void footprint_notConvex_isRefused() {
    List<Point> dart =
        List.of(Point.of(0, 0, 0), Point.of(2, 1, 0), Point.of(1, 0, 0), Point.of(2, -1, 0));

    assertThatThrownBy(() -> new Footprint(dart, 0.0, 1.0))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("convex outline");
  }
}
