package org.u2sa.core.safety;

import static org.assertj.core.api.Assertions.as;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import org.assertj.core.api.InstanceOfAssertFactories;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Envelope;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.Polygon;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;

/** A square of 200 m around the origin with a hole of 20 m in it, from 10 m to 90 m of altitude. */
class FenceTest {
  private static final GeometryFactory GEOMETRY = new GeometryFactory();
  private static final Geodetic ZURICH = new Geodetic(8.5, 47.4, 0.0);

  private static Polygon square(double half) {
    return (Polygon) GEOMETRY.toGeometry(new Envelope(-half, half, -half, half));
  }

  private static Fence fence(Optional<Geodetic> origin) {
    return new Fence(
        origin,
        Optional.of(square(100.0)),
        List.of(square(10.0)),
        OptionalDouble.of(10.0),
        OptionalDouble.of(90.0),
        List.of());
  }

  private static boolean allows(Fence fence, double x, double y) {
    return fence.allows(Point.of(x, y, 0.0));
  }

  @Test
  void allows_exactlyOnAnEdge_ofTheKeepInAreaYesAndOfAKeepOutOneNo() {
    Fence fence = fence(Optional.empty());

    assertThat(allows(fence, 100.0, 50.0)).isTrue();
    assertThat(allows(fence, 100.001, 50.0)).isFalse();
    assertThat(allows(fence, 10.0, 0.0)).isFalse();
    assertThat(allows(fence, 10.001, 0.0)).isTrue();
  }

  @Test
  void drawnIn_byTwenty_isSmallerOnAllSidesAndItsHoleLarger() {
    Fence fence = fence(Optional.empty()).drawnInBy(20.0);

    assertThat(allows(fence, 80.0, 0.0)).isTrue();
    assertThat(allows(fence, 80.001, 0.0)).isFalse();
    assertThat(allows(fence, 30.0, 0.0)).isFalse();
    assertThat(allows(fence, 30.001, 0.0)).isTrue();
    assertThat(fence.floorM).hasValue(30.0);
    assertThat(fence.ceilingM).hasValue(70.0);
  }

  @Test
  void drawnIn_byNothing_isTheSame() {
    Fence fence = fence(Optional.empty());

    assertThat(fence.drawnInBy(0.0)).isSameAs(fence);
  }

  /** Two squares with a passage of 10 m between them. */
  @Test
  void drawnIn_soThatItFallsInTwo_isRefused() {
    Polygon waisted =
        (Polygon)
            GEOMETRY
                .toGeometry(new Envelope(0.0, 100.0, 0.0, 100.0))
                .union(GEOMETRY.toGeometry(new Envelope(100.0, 200.0, 45.0, 55.0)))
                .union(GEOMETRY.toGeometry(new Envelope(200.0, 300.0, 0.0, 100.0)));
    Fence fence =
        new Fence(
            Optional.empty(),
            Optional.of(waisted),
            List.of(),
            OptionalDouble.empty(),
            OptionalDouble.empty(),
            List.of());

    assertThat(fence.drawnInBy(4.0).floorM).isEmpty();
    assertThatThrownBy(() -> fence.drawnInBy(6.0))
        .hasMessage("a margin of 6 m leaves no connected keep-in area");
  }

  @Test
  void corners_onTheEarthOrOnALocalPlane_areThoseOfThePolygon() {
    List<Geodetic> onTheEarth = fence(Optional.of(ZURICH)).corners(new Geodetic(0.0, 0.0, 0.0));
    Geodetic first = onTheEarth.get(0);
    Point seen = Fence.plane(ZURICH, first.longitudeDeg(), first.latitudeDeg());

    assertThat(Math.abs(seen.x())).isCloseTo(100.0, within(0.01));
    assertThat(Math.abs(seen.y())).isCloseTo(100.0, within(0.01));
    assertThat(fence(Optional.empty()).corners(ZURICH)).isEqualTo(onTheEarth);
  }

  @Test
  void keepOutCorners_onTheEarth_areThoseOfEachArea() {
    Polygon hole = (Polygon) GEOMETRY.toGeometry(new Envelope(-20.0, 20.0, -20.0, 20.0));
    Polygon around = (Polygon) GEOMETRY.toGeometry(new Envelope(-90.0, 90.0, -90.0, 90.0));
    Fence fence =
        new Fence(
            Optional.of(ZURICH),
            Optional.of(around),
            List.of(hole),
            OptionalDouble.empty(),
            OptionalDouble.empty(),
            List.of());

    assertThat(fence.drawnInBy(0.0).keepOutCorners(ZURICH))
        .singleElement(as(InstanceOfAssertFactories.list(Geodetic.class)))
        .hasSize(5)
        .allSatisfy(
            corner ->
                assertThat(
                        Math.abs(
                            Fence.plane(ZURICH, corner.longitudeDeg(), corner.latitudeDeg()).x()))
                    .isCloseTo(20.0, within(0.01)));
  }

  private static StateInformation state(ReferenceFrame frame, double x, double y) {
    return new StateInformation().referenceFrame(frame).x(x).y(y);
  }

  @Test
  void place_onTheEarth_isEastAndNorthOfTheOriginWithTheAltitude() {
    Geodetic there = ZURICH.fromEnu(Point.of(30.0, -40.0, 0.0));
    StateInformation state =
        state(ReferenceFrame.GLOBAL, there.longitudeDeg(), there.latitudeDeg()).z(55.0);

    Point place = fence(Optional.of(ZURICH)).place(state);

    assertThat(place.x()).isCloseTo(30.0, within(0.01));
    assertThat(place.y()).isCloseTo(-40.0, within(0.01));
    assertThat(place.z()).isEqualTo(55.0);
  }

  @Test
  void place_ofAStateInNorthEastDown_isTurnedToEastNorthUp() {
    StateInformation state = state(ReferenceFrame.LOCAL_NED, 30.0, -40.0).z(-55.0);
    state.xDot(1.0).yDot(2.0).zDot(3.0);

    assertThat(fence(Optional.empty()).place(state)).isEqualTo(Point.of(-40.0, 30.0, 55.0));
    assertThat(fence(Optional.empty()).velocity(state)).isEqualTo(Point.of(2.0, 1.0, -3.0));
  }

  @Test
  void place_altitudeAndVelocityNotKnown_areZero() {
    StateInformation state = state(ReferenceFrame.LOCAL_ENU, 30.0, -40.0);

    assertThat(fence(Optional.empty()).place(state)).isEqualTo(Point.of(30.0, -40.0, 0.0));
    assertThat(fence(Optional.empty()).velocity(state)).isEqualTo(Point.of(0.0, 0.0, 0.0));
  }

  @Test
  void place_stateOfAnotherKindOfFrame_isRefusedNamingBoth() {
    StateInformation local = state(ReferenceFrame.LOCAL_ENU, 0.0, 0.0);
    StateInformation global = state(ReferenceFrame.GLOBAL, 8.5, 47.4);

    assertThatThrownBy(() -> fence(Optional.of(ZURICH)).place(local))
        .hasMessage("a state in LOCAL_ENU does not fit a fence on the earth");
    assertThatThrownBy(() -> fence(Optional.empty()).place(global))
        .hasMessage("a state in GLOBAL does not fit a fence on a local plane");
  }

  /** Moving such borders takes many seconds and gigabytes. */
  @Test
  void drawnIn_starWhoseSpikesAreNarrowerThanTheMargin_isRefused() {
    Coordinate[] ring = new Coordinate[1181];
    for (int i = 0; i < 1180; i++) {
      double radiusM = i % 2 == 0 ? 100.0 : 3000.0;
      double angle = 2.0 * Math.PI * i / 1180;
      ring[i] = new Coordinate(radiusM * Math.cos(angle), radiusM * Math.sin(angle));
    }
    ring[1180] = ring[0].copy();
    Polygon star = GEOMETRY.createPolygon(ring);
    OptionalDouble any = OptionalDouble.empty();
    Fence fence = new Fence(Optional.empty(), Optional.empty(), List.of(star), any, any, List.of());

    assertThatThrownBy(() -> fence.drawnInBy(50.0))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage(
            "more than 10000 pairs of sides of its areas cross or are within twice a margin of 50 m, or it has too many sides to compare them; expected fewer corners");
    assertThat(allows(fence.drawnInBy(0.01), 2000.0, 0.0)).isTrue();
  }

  private static Polygon comb(boolean isUpright) {
    List<Coordinate> ring = new ArrayList<>();
    for (int i = 0; i <= 100; i++) {
      ring.add(new Coordinate(10.0 * i, 0.0));
      ring.add(new Coordinate(10.0 * i + 5.0, 1000.0));
    }
    ring.add(new Coordinate(1010.0, -5.0));
    ring.add(new Coordinate(-5.0, -5.0));
    ring.add(ring.get(0).copy());
    ring.forEach(
        each -> {
          if (!isUpright) {
            each.setCoordinate(new Coordinate(each.y, each.x));
          }
        });
    return GEOMETRY.createPolygon(ring.toArray(new Coordinate[0]));
  }

  /** Joining them takes seconds when the vehicle has to return. */
  @Test
  void drawnIn_twoCombsThatCross_areRefusedWithoutAMarginToo() {
    OptionalDouble any = OptionalDouble.empty();
    List<Polygon> combs = List.of(comb(true), comb(false));
    Fence fence = new Fence(Optional.empty(), Optional.empty(), combs, any, any, List.of());

    assertThatThrownBy(() -> fence.drawnInBy(0.0))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("more than 10000 pairs of sides of its areas cross");
  }

  /** 200 km away the earth is 3 km below the plane of the first corner. */
  @ParameterizedTest
  @ValueSource(doubles = {0.1, 1.0, 3.0})
  void keepOutCorners_farFromTheFirstCorner_areWhereTheFileHasThem(double farDeg) {
    String far =
        String.format(
            Locale.ROOT,
            "<keepOut><corner><x>%1$f</x><y>%2$f</y></corner><corner><x>%3$f</x><y>%2$f</y></corner>"
                + "<corner><x>%3$f</x><y>%4$f</y></corner></keepOut>",
            8.5 + farDeg,
            47.4 + farDeg,
            8.51 + farDeg,
            47.41 + farDeg);
    String near =
        "<keepOut><corner><x>8.5</x><y>47.4</y></corner><corner><x>8.51</x><y>47.4</y></corner>"
            + "<corner><x>8.51</x><y>47.41</y></corner></keepOut>";
    Fence fence = GivenFence.of("f", "<fence>" + near + far + "</fence>", 0.0).fence();

    Geodetic first = fence.keepOutCorners(ZURICH).get(1).get(0);
    assertThat(first.distanceM(new Geodetic(8.5 + farDeg, 47.4 + farDeg, first.altitudeM())))
        .isLessThan(0.1);
  }
}
