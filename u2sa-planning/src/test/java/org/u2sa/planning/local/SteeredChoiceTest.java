package org.u2sa.planning.local;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.route.Route;
import org.u2sa.planning.search.BodyDiscs;
import org.u2sa.planning.search.CostGrid;
import org.u2sa.planning.search.GridFrame;
import org.u2sa.planning.search.Inflation;
import org.u2sa.planning.seen.Mover;
import org.u2sa.service.motion.Drift;

/** A boat of 1.2 m without sideways thrust, with a current of 0.3 m/s from astern. */
class SteeredChoiceTest {
  private static final MotionLimits LIMITS =
      new MotionLimits(1.2, 0.5, 0.4, 0.0, true, 1.2, 4.0, 0.1, 0.0, 0.5, 8.0, 0.5, 0.4, 0.0);
  private static final double STEP_S = 0.2;

  private final CostGrid costs =
      new CostGrid(new GridFrame(-30.0, -30.0, 0.5, 120, 120), new Inflation(0.6, 1.0, 3.0));

  private static Mover boat(double northM, double southMps) {
    return new Mover(
        "boat", 0L, 0.0, new double[] {northM}, new double[] {0.3}, -southMps, 0.0, 1.5);
  }

  private ArcChoice choose(Mover boat, Pose pose, double mps, Optional<ArcChoice> before) {
    Route.Point from = new Route.Point(0.0, 0.0, false);
    Route.Point to = new Route.Point(25.0, 0.0, false);
    ArcChooser arcs =
        new ArcChooser(
            costs,
            new BodyDiscs(0.6, 0.6, 0.7),
            List.of(boat),
            LIMITS,
            pose,
            mps,
            0L,
            before,
            Optional.empty(),
            new Drift(0.3, 0.0));
    return arcs.along(new RouteTrack(Route.of(List.of(from, to), 25.0)));
  }

  @ParameterizedTest
  @CsvSource({"3.0, 0.3", "3.0, 0.8", "3.5, 0.6", "4.0, 1.0", "4.5, 1.2"})
  void along_boatCloseAhead_doesNotDriveTowardsIt(double northM, double mps) {
    ArcChoice choice =
        choose(boat(northM, 0.4), new Pose(0.0, 0.0, 0.0), mps, Optional.<ArcChoice>empty());

    double bearing = Math.atan2(choice.eastM(), choice.northM());
    boolean isAhead = !choice.backwards() && Math.abs(bearing) < Math.toRadians(45.0);
    assertThat(isAhead ? choice.speedMps() : 0.0).isZero();
  }

  @Test
  void along_evasionUnderWay_goesOnInItsDirection() {
    Optional<ArcChoice> before = Optional.empty();
    int changes = 0;
    for (int i = 0; i < 20; i++) {
      Pose pose = new Pose(-0.02 * i, 0.05 * Math.sin(i), 0.02 * Math.cos(i));
      ArcChoice choice = choose(boat(4.0 - 0.4 * STEP_S * i, 0.4), pose, 0.1, before);
      if (before.isPresent()) {
        double turned =
            Math.atan2(choice.eastM() - pose.eastM(), choice.northM() - pose.northM())
                - Math.atan2(
                    before.get().eastM() - pose.eastM(), before.get().northM() - pose.northM());
        changes += Math.abs(Pose.wrapped(turned)) > Math.toRadians(20.0) ? 1 : 0;
      }
      before = Optional.of(choice);
    }
    assertThat(changes).isLessThanOrEqualTo(2);
  }

  /** A dock, open astern, in which it can turn but comes closer to the walls than routes do. */
  @Test
  void along_turnInADock_backsOutFirst() {
    GridFrame frame = new GridFrame(-12.0, -12.0, 0.1, 240, 240);
    CostGrid dock = new CostGrid(frame, new Inflation(1.0, 1.5, 3.0));
    dock.update(
        i -> {
          boolean isBeside = Math.abs(Math.abs(frame.centreEastM(i)) - 0.95) < 0.1;
          double north = frame.centreNorthM(i);
          boolean isAhead = Math.abs(frame.centreEastM(i)) < 0.95 && Math.abs(north - 1.2) < 0.1;
          return isAhead || isBeside && north > -1.5 && north < 1.2;
        },
        i -> false);
    MotionLimits limits =
        new MotionLimits(1.2, 0.5, 0.4, 0.0, true, 0.4, 2.0, 0.05, 0.0, 0.5, 8.0, 0.5, 0.4, 0.4);
    Route.Point from = new Route.Point(0.0, 0.0, false);
    Route.Point to = new Route.Point(-25.0, 3.0, false);
    ArcChoice choice =
        new ArcChooser(
                dock,
                BodyDiscs.closely(0.6, 0.6, 0.7, 0.15),
                List.of(),
                limits,
                new Pose(0.0, 0.0, 0.0),
                -0.1,
                0L,
                Optional.empty(),
                Optional.empty(),
                new Drift(-0.12, 0.0))
            .along(new RouteTrack(Route.of(List.of(from, to), 25.0)));

    assertThat(choice.kind()).isEqualTo(ArcChoice.Kind.MAKE_ROOM);
    assertThat(choice.backwards()).isTrue();
  }
}
