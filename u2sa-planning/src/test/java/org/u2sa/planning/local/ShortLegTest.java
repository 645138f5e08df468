package org.u2sa.planning.local;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.route.Route;
import org.u2sa.planning.search.BodyDiscs;
import org.u2sa.planning.search.CostGrid;
import org.u2sa.planning.search.GridFrame;
import org.u2sa.planning.search.Inflation;
import org.u2sa.service.motion.Drift;

/** Routes with short legs between cusps; a control stops 0.15 to 0.3 m short of its point. */
class ShortLegTest {
  private static final double REACHED_M = 0.15;

  private final CostGrid costs =
      new CostGrid(new GridFrame(-8.0, -8.0, 0.1, 160, 160), new Inflation(0.5, 1.0, 3.0));

  private ArcChoice along(RouteTrack track, double turnRadiusM, double northM) {
    return new ArcChooser(
            costs,
            new BodyDiscs(0.3, 0.3, 0.5),
            List.of(),
            new MotionLimits(
                1.0, 0.8, 0.8, turnRadiusM, true, 1.0, 0.6, 0.05, 0.0, 0.3, 4.0, 0.3, 0.8, 0.2),
            new Pose(northM, 0.0, 0.0),
            0.0,
            0L,
            Optional.empty(),
            Optional.empty(),
            Drift.NONE)
        .along(track);
  }

  /** Back to a northing, then ahead to another, from the origin. */
  private static RouteTrack backAndAhead(double cuspM, double endM) {
    return new RouteTrack(
        Route.of(
            List.of(
                new Route.Point(0.0, 0.0, true),
                new Route.Point(cuspM, 0.0, true),
                new Route.Point(endM, 0.0, false)),
            3.0));
  }

  @Test
  void along_shortLegInReverse_leadsSlowlyBeyondItsCusp() {
    ArcChoice choice = along(backAndAhead(-0.2, 0.0), 1.0, 0.0);
    assertThat(choice.backwards()).isTrue();
    assertThat(choice.northM()).isCloseTo(-0.35, within(1e-9));
    assertThat(choice.speedMps()).isEqualTo(0.2);
  }

  @Test
  void along_shortLegPassed_leadsToItsEnd() {
    RouteTrack track = backAndAhead(-0.2, 0.0);
    track.follow(-0.2, 0.0, REACHED_M, 0.6);
    track.follow(0.01, 0.0, REACHED_M, 0.6);
    ArcChoice choice = along(track, 1.0, 0.01);
    assertThat(choice.northM()).isCloseTo(0.0, within(1e-9));
  }

  @Test
  void along_shortLegOfAVehicleThatTurnsInPlace_leadsToItsCusp() {
    assertThat(along(backAndAhead(-0.2, 0.0), 0.0, 0.0).northM()).isCloseTo(-0.2, within(1e-9));
  }

  @Test
  void along_longLeg_leadsToItsCusp() {
    RouteTrack track = backAndAhead(-1.0, 0.0);
    track.follow(-0.8, 0.0, REACHED_M, 0.6);
    assertThat(along(track, 1.0, -0.8).northM()).isCloseTo(-1.0, within(1e-9));
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.2, 0.4, 1.0})
  void follow_cuspOfALeg_isReachedInItsLastQuarterAtTheEarliest(double legM) {
    RouteTrack track = backAndAhead(-legM, 0.0);
    double reached = Math.min(REACHED_M, 0.25 * legM);
    track.follow(-legM + reached + 0.01, 0.0, REACHED_M, 0.6);
    assertThat(track.goesBackwards()).isTrue();
    track.follow(-legM + reached - 0.01, 0.0, REACHED_M, 0.6);
    assertThat(track.goesBackwards()).isFalse();
    assertThat(track.isAtEnd(REACHED_M)).isFalse();
    track.follow(-reached + 0.01, 0.0, REACHED_M, 0.6);
    assertThat(track.isAtEnd(REACHED_M)).isTrue();
  }
}
