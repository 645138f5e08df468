package org.u2sa.planning.local;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.messages.frame.Point;
import org.u2sa.planning.search.CostGrid;
import org.u2sa.planning.search.GridFrame;
import org.u2sa.planning.search.Inflation;
import org.u2sa.planning.seen.Mover;
import org.u2sa.planning.seen.PlanarShape;

/** A multirotor 20 m above a plain, from which hills rise on both sides, and a drone that comes. */
class HoverMotionsTest {
  private static final double HIGH_M = 20.0;
  private static final double KEPT_M = 3.0; // from the ground
  private static final MotionLimits LIMITS =
      new MotionLimits(8.0, 2.0, 2.0, 0.0, true, 0.0, 8.0, 1.0, 0.0, 5.0, 20.0, 0.5, 1.0, 0.0);
  private static final CostGrid COSTS =
      new CostGrid(new GridFrame(-100.0, -100.0, 1.0, 200, 200), new Inflation(0.6, 6.0, 3.0));

  static {
    COSTS.update(new byte[200 * 200]);
  }

  private static double groundDownM(double north, double east) {
    return -2.0 * Math.max(0.0, Math.abs(east) - 10.0); // a slope of 2 : 1, 10 m beside it
  }

  @ParameterizedTest
  @ValueSource(doubles = {3.0, 6.0, 9.0})
  void choose_hillsBeside_doesNotFlyIntoThem(double mps) {
    Mover drone =
        new Mover(
            "drone",
            0L,
            0.0,
            new double[] {-60.0},
            new double[] {0.0},
            mps,
            0.0,
            20.0,
            0.0,
            0.0,
            new Mover.Heights(new double[] {-HIGH_M}, 0.0, 20.0));
    VerticalRoom room =
        new VerticalRoom(
            -HIGH_M,
            -HIGH_M,
            2.0,
            5.0,
            KEPT_M,
            KEPT_M,
            1.0,
            -HIGH_M,
            Double.POSITIVE_INFINITY,
            List.of(),
            HoverMotionsTest::groundDownM,
            0);
    HoverMotions motions =
        new HoverMotions(
            COSTS, 0.6, 3.0, List.of(drone), LIMITS, Optional.of(room), new Area.Uniform(true), 0L);
    Point here = Point.of(0.0, 0.0, -HIGH_M);
    Point spot = motions.choose(here, Point.ORIGIN, here, Optional.empty()).orElseThrow().spot();

    double aboveM = groundDownM(spot.x(), spot.y()) - spot.z();
    assertThat(aboveM).isGreaterThanOrEqualTo(KEPT_M - 0.1);
  }

  /** The straight way back would lead through it, although the traffic has gone. */
  @Test
  void choose_keepOutAreaOnTheWayBack_goesToASpotFromWhereTheWayIsFree() {
    Area beside = new Wall();
    HoverMotions motions =
        new HoverMotions(COSTS, 0.6, 3.0, List.of(), LIMITS, Optional.empty(), beside, 0L);
    Point at = Point.of(20.0, 0.0, -HIGH_M);
    Point home = Point.of(0.0, 0.0, -HIGH_M);
    Point before = Point.of(16.0, 16.0, -HIGH_M);

    Point spot = motions.choose(at, Point.ORIGIN, home, Optional.of(before)).orElseThrow().spot();
    assertThat(beside.allows(at.x(), at.y(), spot.x(), spot.y())).isTrue();
    assertThat(beside.allows(spot.x(), spot.y(), home.x(), home.y())).isTrue();
    assertThat(motions.choose(at, Point.ORIGIN, home, Optional.empty()))
        .as("it has not evaded")
        .isEmpty();
  }

  /** A thin keep-out area 10 m north of home, 10 m wide. */
  private static final class Wall implements Area {
    @Override
    public boolean contains(double northM, double eastM) {
      return true;
    }

    @Override
    public boolean allows(double northM, double eastM, double toNorthM, double toEastM) {
      return !PlanarShape.cross(northM, eastM, toNorthM, toEastM, 10.0, -5.0, 10.0, 5.0);
    }

    @Override
    public double roomM(double northM, double eastM) {
      return Math.hypot(northM - 10.0, Math.max(0.0, Math.abs(eastM) - 5.0));
    }
  }
}
