package org.u2sa.planning.local;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.messages.frame.Point;
import org.u2sa.planning.search.CostGrid;
import org.u2sa.planning.search.GridFrame;
import org.u2sa.planning.search.Inflation;
import org.u2sa.planning.seen.Mover;

/** A multirotor 20 m above a plain, from which hills rise on both sides, and a drone that comes. */
class HoverMotionsTest {
  private static final double HIGH_M = 20.0;
  private static final double KEPT_M = 3.0; // from the ground

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
    MotionLimits limits =
        new MotionLimits(8.0, 2.0, 2.0, 0.0, true, 0.0, 8.0, 1.0, 0.0, 5.0, 20.0, 0.5, 1.0);
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
    CostGrid costs =
        new CostGrid(new GridFrame(-100.0, -100.0, 1.0, 200, 200), new Inflation(0.6, 6.0, 3.0));
    costs.update(new byte[200 * 200]);
    HoverMotions motions =
        new HoverMotions(
            costs, 0.6, 3.0, List.of(drone), limits, Optional.of(room), new Everywhere(), 0L);
    Point here = Point.of(0.0, 0.0, -HIGH_M);
    Point spot = motions.choose(here, Point.ORIGIN, here, Optional.empty()).orElseThrow().spot();

    double aboveM = groundDownM(spot.x(), spot.y()) - spot.z();
    assertThat(aboveM).isGreaterThanOrEqualTo(KEPT_M - 0.1);
  }

  /** No fence. */
  private static final class Everywhere implements Area {
    @Override
    public boolean contains(double northM, double eastM) {
      return true;
    }

    @Override
    public boolean allows(double northM, double eastM, double toNorthM, double toEastM) {
      return true;
    }
  }
}
