package org.u2sa.planning.curve;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;

/** Shortest ways end where they should, and no way made at random to the same place is shorter. */
class CurveProperties {
  private static final double RADIUS = 2.5;

  @Property(tries = 2000)
  void dubins_randomWord_isNeverLongerAndEndsThere(@ForAll long seed) {
    Random random = new Random(seed);
    Pose from = pose(random);
    Curve other = word(random, false);
    Pose to = other.end(from);

    Curve shortest = Dubins.shortest(from, to, RADIUS);

    assertEnds(shortest, from, to);
    assertThat(shortest.lengthM()).isLessThanOrEqualTo(other.lengthM() + 1.0e-6);
    assertThat(shortest.pieces()).allMatch(piece -> piece.lengthM() >= 0.0);
  }

  @Property(tries = 1000)
  void dubinsAll_anyPoses_endThereAndContainTheShortest(@ForAll long seed) {
    Random random = new Random(seed);
    Pose from = pose(random);
    Pose to = pose(random);

    List<Curve> all = Dubins.all(from, to, RADIUS);

    all.forEach(curve -> assertEnds(curve, from, to));
    assertThat(all).contains(Dubins.shortest(from, to, RADIUS));
  }

  @Property(tries = 2000)
  void dubinsToPlace_randomWord_isNeverLongerAndEndsThere(@ForAll long seed) {
    Random random = new Random(seed);
    Pose from = pose(random);
    Curve other = word(random, false);
    Pose to = other.end(from);

    Curve shortest = Dubins.shortest(from, to.northM(), to.eastM(), RADIUS);

    Pose end = shortest.end(from);
    assertThat(end.distanceM(to.northM(), to.eastM())).isLessThan(1.0e-6);
    assertThat(shortest.lengthM()).isLessThanOrEqualTo(other.lengthM() + 1.0e-6);
  }

  @Property(tries = 5000)
  void reedsShepp_randomWord_isNeverLongerAndEndsThere(@ForAll long seed) {
    Random random = new Random(seed);
    Pose from = pose(random);
    Curve other = word(random, true);
    Pose to = other.end(from);

    Curve shortest = ReedsShepp.shortest(from, to, RADIUS);

    assertEnds(shortest, from, to);
    assertThat(shortest.lengthM()).isLessThanOrEqualTo(other.lengthM() + 1.0e-6);
  }

  /** The search may stop at what is short enough, but what counts must be exact. */
  @Property(tries = 2000)
  void reedsSheppLength_enough_isTheShortestOrNoLongerThanThat(@ForAll long seed) {
    Random random = new Random(seed);
    Pose from = pose(random);
    Pose to = pose(random);
    double shortest = ReedsShepp.shortest(from, to, RADIUS).lengthM();
    double enough = 2.0 * shortest * random.nextDouble();

    double length = ReedsShepp.lengthM(from, to, RADIUS, enough);

    assertThat(Math.max(enough, length)).isEqualTo(Math.max(enough, shortest));
  }

  @Property(tries = 500)
  void reedsShepp_thereAndBack_isAsLong(@ForAll long seed) {
    Random random = new Random(seed);
    Pose a = pose(random);
    Pose b = pose(random);

    assertThat(ReedsShepp.shortest(a, b, RADIUS).lengthM())
        .isCloseTo(ReedsShepp.shortest(b, a, RADIUS).lengthM(), within(1.0e-6));
    assertThat(ReedsShepp.shortest(a, b, RADIUS).lengthM())
        .isLessThanOrEqualTo(Dubins.shortest(a, b, RADIUS).lengthM() + 1.0e-6);
  }

  @Example
  void shortest_noRadius_isRefused() {
    Pose from = new Pose(0.0, 0.0, 0.0);
    Pose to = new Pose(10.0, 5.0, 1.0);
    assertThatThrownBy(() -> Dubins.shortest(from, to, 0.0)).hasMessageContaining("above 0");
    assertThatThrownBy(() -> Dubins.shortest(from, 10.0, 5.0, 0.0)).hasMessageContaining("above 0");
    assertThatThrownBy(() -> ReedsShepp.shortest(from, to, 0.0)).hasMessageContaining("above 0");
  }

  private static void assertEnds(Curve curve, Pose from, Pose to) {
    Pose end = curve.end(from);
    assertThat(end.distanceM(to.northM(), to.eastM())).as("%s", curve).isLessThan(1.0e-5);
    assertThat(Math.abs(Pose.wrapped(end.headingRad() - to.headingRad()))).isLessThan(1.0e-5);
  }

  private static Pose pose(Random random) {
    return new Pose(
        20.0 * (random.nextDouble() - 0.5),
        20.0 * (random.nextDouble() - 0.5),
        2.0 * Math.PI * (random.nextDouble() - 0.5));
  }

  /** One to five arcs and straights. */
  private static Curve word(Random random, boolean backwards) {
    List<Curve.Piece> pieces = new ArrayList<>();
    int count = 1 + random.nextInt(5);
    for (int i = 0; i < count; i++) {
      double length = random.nextDouble() * random.nextDouble() * 2.0 * Math.PI * RADIUS;
      double sign = backwards && random.nextBoolean() ? -1.0 : 1.0;
      pieces.add(new Curve.Piece(sign * length, (random.nextInt(3) - 1) / RADIUS));
    }
    return new Curve(pieces);
  }
}
