package org.u2sa.world.object;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.messages.frame.Point;

/** Standing and moving objects, by noisy sightings. */
class TrackFilterTest {
  private static final TrackFilter.Assumptions USUAL = new TrackFilter.Assumptions(5.0, 1.0, 0.0);
  private static final Point SIGMA = Point.of(0.3, 0.3, 0.3);

  private static Point noisy(Random random, double x, double y) {
    return Point.of(
        x + 0.3 * random.nextGaussian(),
        y + 0.3 * random.nextGaussian(),
        0.3 * random.nextGaussian());
  }

  private static TrackFilter filter(Point first) {
    return new TrackFilter(first, SIGMA, Optional.empty(), OptionalDouble.empty(), USUAL);
  }

  private static void see(TrackFilter filter, Point at) {
    filter.predict(0.2);
    filter.update(at, SIGMA, Optional.empty(), OptionalDouble.empty());
  }

  @Test
  void update_standing_placeGetsAsSureAsTheMean() {
    Random random = new Random(1L);
    int believedToMove = 0;
    for (int run = 0; run < 50; run++) {
      TrackFilter filter = filter(noisy(random, 10.0, -4.0));
      for (int i = 1; i < 100; i++) {
        see(filter, noisy(random, 10.0, -4.0));
      }
      believedToMove += filter.isMoving() ? 1 : 0;
      if (!filter.isMoving()) {
        assertThat(filter.sigma().x()).isBetween(0.0299, 0.06); // 0.3 / √100
        assertThat(filter.place().distanceTo(Point.of(10.0, -4.0, 0.0))).isLessThan(0.15);
      }
    }
    assertThat(believedToMove).isLessThanOrEqualTo(1);
  }

  @Test
  void update_moving_velocityIsFoundAndHonest() {
    Random random = new Random(2L);
    double squared = 0.0;
    int runs = 200;
    for (int run = 0; run < runs; run++) {
      TrackFilter filter = filter(noisy(random, 0.0, 0.0));
      for (int i = 1; i <= 25; i++) {
        see(filter, noisy(random, 0.3 * i, -0.1 * i)); // 1.5 and -0.5 m/s
      }
      assertThat(filter.isMoving()).isTrue();
      assertThat(filter.velocity().distanceTo(Point.of(1.5, -0.5, 0.0))).isLessThan(1.6);
      squared += Math.pow((filter.place().x() - 7.5) / filter.sigma().x(), 2.0);
    }
    assertThat(squared / runs).isBetween(0.5, 1.3); // it allows for manoeuvres that do not come
  }

  @Test
  void update_standsThenGoesThenStops_isFollowed() {
    Random random = new Random(3L);
    TrackFilter filter = filter(noisy(random, 0.0, 0.0));
    for (int i = 0; i < 100; i++) {
      see(filter, noisy(random, 0.0, 0.0));
    }
    assertThat(filter.isMoving()).isFalse();
    double x = 0.0;
    for (int i = 0; i < 15; i++) {
      x += 0.4;
      see(filter, noisy(random, x, 0.0));
    }
    assertThat(filter.isMoving()).isTrue();
    assertThat(filter.place().x()).isCloseTo(x, within(0.6));
    for (int i = 0; i < 60; i++) {
      see(filter, noisy(random, x, 0.0));
    }
    assertThat(filter.isMoving()).isFalse();
    assertThat(filter.place().x()).isCloseTo(x, within(0.25));
  }

  @Test
  void update_statedVelocity_isBelievedAtOnce() {
    TrackFilter filter =
        new TrackFilter(
            Point.ORIGIN,
            SIGMA,
            Optional.of(Point.of(50.0, 0.0, 2.0)),
            OptionalDouble.of(0.5),
            USUAL);
    assertThat(filter.isMoving()).isTrue();
    filter.predict(2.0);
    assertThat(filter.place().x()).isCloseTo(100.0, within(1e-9));
  }

  @Test
  void update_nothingMovesByConfiguration_isNeverMoving() {
    TrackFilter filter =
        new TrackFilter(
            Point.ORIGIN,
            SIGMA,
            Optional.empty(),
            OptionalDouble.empty(),
            new TrackFilter.Assumptions(0.0, 1.0, 0.0));
    for (int i = 0; i < 20; i++) {
      see(filter, Point.of(i, 0.0, 0.0));
    }
    assertThat(filter.isMoving()).isFalse();
  }

  @Test
  void update_turnsQuickly_isFollowedAllTheSame() {
    Random random = new Random(5L);
    TrackFilter filter = filter(noisy(random, 0.0, 0.0));
    for (int i = 1; i <= 40; i++) {
      see(filter, noisy(random, 0.6 * i, 0.0)); // 3 m/s
    }
    for (int i = 1; i <= 10; i++) {
      see(filter, noisy(random, 24.0, 0.6 * i));
    }
    assertThat(filter.isMoving()).isTrue();
    assertThat(filter.place().distanceTo(Point.of(24.0, 6.0, 0.0))).isLessThan(0.8);
    assertThat(filter.velocity().distanceTo(Point.of(0.0, 3.0, 0.0))).isLessThan(1.2);
  }

  @Test
  void update_goesSteadily_velocityIsFarSurerThanManoeuvresAllow() {
    Random random = new Random(6L);
    TrackFilter filter = filter(noisy(random, 0.0, 0.0));
    for (int i = 1; i <= 80; i++) {
      see(filter, noisy(random, 0.1 * i, 0.0)); // 0.5 m/s
    }
    assertThat(filter.isMoving()).isTrue();
    assertThat(filter.velocitySigma()).isLessThan(0.2); // of what may turn at will: 0.7 m/s
    assertThat(filter.velocity().distanceTo(Point.of(0.5, 0.0, 0.0))).isLessThan(0.3);
  }

  /** Sightings of a transponder: much less accurate in altitude. */
  private static TrackFilter heard(Random random, TrackFilter before, double z, double speed) {
    Point at = noisy(random, 0.0, 0.0).plus(Point.of(0.0, 0.0, z));
    Point sigma = Point.of(3.0, 3.0, 30.0);
    Optional<Point> velocity = Optional.of(Point.of(0.0, 0.0, speed));
    OptionalDouble accuracy = OptionalDouble.of(2.0);
    if (before == null) {
      TrackFilter.Assumptions aircraft = new TrackFilter.Assumptions(25.0, 1.0, 0.05);
      return new TrackFilter(at, sigma, velocity, accuracy, aircraft);
    }
    before.predict(1.0);
    before.update(at, sigma, velocity, accuracy);
    return before;
  }

  @ParameterizedTest
  @ValueSource(doubles = {3.0, -3.0, -6.0})
  void update_statedSlowDescentOrClimb_isFollowed(double mps) {
    Random random = new Random(7L);
    TrackFilter filter = null;
    for (int second = 0; second < 40; second++) {
      filter = heard(random, filter, mps * second, mps);
      if (second > 12) {
        assertThat(filter.isMoving()).isTrue();
        assertThat(filter.place().z()).isCloseTo(mps * second, within(4.0));
        assertThat(filter.velocity().z()).isCloseTo(mps, within(1.0));
      }
    }
  }

  @Test
  void update_inaccurateVelocitiesOfStandingTraffic_isBelievedToStand() {
    Random random = new Random(8L);
    int believedToMove = 0;
    for (int run = 0; run < 50; run++) {
      TrackFilter filter = null;
      for (int second = 0; second < 100; second++) {
        filter = heard(random, filter, 0.0, 2.0 * random.nextGaussian());
        believedToMove += second > 20 && filter.isMoving() ? 1 : 0;
      }
    }
    assertThat(believedToMove).isZero();
  }
}
