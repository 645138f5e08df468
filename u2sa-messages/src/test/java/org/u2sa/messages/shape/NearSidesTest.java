package org.u2sa.messages.shape;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Point;

class NearSidesTest {
  private static List<Point> star(int corners, double innerM, double outerM) {
    List<Point> ring = new ArrayList<>();
    for (int i = 0; i < corners; i++) {
      double radiusM = i % 2 == 0 ? innerM : outerM;
      double angle = 2.0 * Math.PI * i / corners;
      ring.add(Point.of(radiusM * Math.cos(angle), radiusM * Math.sin(angle), 0.0));
    }
    return ring;
  }

  private static List<Point> square(double x) {
    return List.of(
        Point.of(x, 0.0, 0.0),
        Point.of(x + 10.0, 0.0, 0.0),
        Point.of(x + 10.0, 10.0, 0.0),
        Point.of(x, 10.0, 0.0));
  }

  private static int count(List<Point> border, double distanceM, int limit) {
    return NearSides.count(List.of(border), distanceM, limit);
  }

  @Test
  void count_starWithNarrowSpikes_areItsPairsOfSidesUpToTheLimit() {
    assertThat(count(star(10, 10.0, 100.0), 1e9, 1_000)).isEqualTo(10 * 9 / 2);
    assertThat(count(star(10, 10.0, 100.0), 1e9, 20)).isGreaterThan(20);
    assertThat(count(star(10, 100.0, 200.0), 1.0, 1_000)).isEqualTo(10); // neighbours
  }

  @Test
  void count_convexBorder_isNoneHoweverNear() {
    assertThat(count(star(64, 10.0, 10.0), 1e9, 1_000)).isZero();
  }

  @Test
  void count_twoSquares_areTheSidesWithinTheDistanceOfTheOther() {
    List<List<Point>> both = List.of(square(0.0), square(15.0));

    assertThat(NearSides.count(both, 4.9, 100)).isZero();
    assertThat(NearSides.count(both, 1e3, 100)).isZero(); // both are convex
    List<Point> crossing =
        List.of(Point.of(-5.0, 5.0, 0.0), Point.of(5.0, 4.0, 0.0), Point.of(5.0, 6.0, 0.0));
    assertThat(NearSides.count(List.of(square(0.0), crossing), 0.0, 100)).isEqualTo(2);
    List<Point> dented = new ArrayList<>(square(15.0));
    dented.add(Point.of(18.0, 5.0, 0.0));
    List<List<Point>> one = List.of(square(0.0), dented);
    assertThat(NearSides.count(one, 4.9, 100)).isEqualTo(count(dented, 4.9, 100));
    assertThat(NearSides.count(one, 5.1, 100)).isGreaterThan(count(dented, 5.1, 100));
  }

  @Test
  void count_moreNestedCirclesThanCanBeCompared_exceedsTheLimit() {
    List<List<Point>> few = new ArrayList<>();
    List<List<Point>> many = new ArrayList<>();
    for (int i = 0; i < 800; i++) {
      List<Point> circle = star(64, 1.0 + 0.01 * i, 1.0 + 0.01 * i);
      many.add(circle);
      if (i < 50) {
        few.add(circle);
      }
    }

    assertThat(NearSides.count(few, 1.0, 1_000)).isZero();
    assertThat(NearSides.count(many, 1.0, 1_000)).isGreaterThan(1_000);
  }
}
