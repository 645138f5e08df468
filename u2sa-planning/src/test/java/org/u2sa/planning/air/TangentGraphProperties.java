package org.u2sa.planning.air;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.planning.curve.Curve;
import org.u2sa.planning.curve.Dubins;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.seen.PlanarShape;

/** Arcs and tangents around discs and areas. */
class TangentGraphProperties {
  private static final double RADIUS = 50.0;
  private static final double CLEARANCE = 12.0;

  @Property(tries = 300)
  void shortest_randomDiscs_keepsClearTurnsNoTighterAndEndsAtTheGoal(@ForAll long seed) {
    Random random = new Random(seed);
    List<PlanarShape> discs = new ArrayList<>();
    for (int i = 0; i < 12; i++) {
      double north = 200.0 + 800.0 * random.nextDouble();
      double east = 600.0 * (random.nextDouble() - 0.5);
      discs.add(PlanarShape.disc("D" + i, north, east, 10.0 + 70.0 * random.nextDouble()));
    }
    Pose start = new Pose(0.0, 0.0, random.nextDouble() - 0.5);
    OptionalDouble heading =
        random.nextBoolean()
            ? OptionalDouble.of(6.0 * random.nextDouble())
            : OptionalDouble.empty();

    Optional<Curve> way =
        TangentGraph.shortest(discs, List.of(), CLEARANCE, start, 1300.0, 0.0, heading, RADIUS);

    way.ifPresent(
        curve -> {
          Pose end = curve.end(start);
          assertThat(end.distanceM(1300.0, 0.0)).isLessThan(1.0e-3);
          heading.ifPresent(
              wanted ->
                  assertThat(Math.abs(Math.IEEEremainder(end.headingRad() - wanted, 2.0 * Math.PI)))
                      .isLessThan(1.0e-5));
          assertThat(curve.pieces())
              .allMatch(piece -> Math.abs(piece.curvature()) <= 1.0 / RADIUS + 1.0e-9);
          for (Curve.Sample sample : curve.sampled(start, 2.0)) {
            for (PlanarShape disc : discs) {
              assertThat(disc.distanceM(sample.pose().northM(), sample.pose().eastM()))
                  .isGreaterThan(0.93 * CLEARANCE);
            }
          }
        });
  }

  private static Optional<Curve> shortest(Pose start, Pose goal, OptionalDouble heading) {
    return TangentGraph.shortest(
        List.of(), List.of(), CLEARANCE, start, goal.northM(), goal.eastM(), heading, RADIUS);
  }

  @Property(tries = 1000)
  void shortest_nothingInTheWay_isDubinss(@ForAll long seed) {
    Random random = new Random(seed);
    Pose start = new Pose(0.0, 0.0, 6.0 * random.nextDouble());
    double away = random.nextBoolean() ? 900.0 : 250.0 * random.nextDouble(); // or a close turn
    Pose goal = new Pose(away, 100.0 * random.nextDouble(), 6.0 * random.nextDouble());

    Optional<Curve> way = shortest(start, goal, OptionalDouble.of(goal.headingRad()));

    assertThat(way.orElseThrow().end(start).distanceM(goal.northM(), goal.eastM()))
        .isLessThan(1.0e-3);
    assertThat(way.orElseThrow().lengthM())
        .isCloseTo(Dubins.shortest(start, goal, RADIUS).lengthM(), within(1.0e-2));
  }

  @Property(tries = 100)
  void shortest_anyHeadingAtTheGoal_isAsShortAsDubinssBest(@ForAll long seed) {
    Random random = new Random(seed);
    Pose start = new Pose(0.0, 0.0, 6.0 * random.nextDouble());
    Pose goal = new Pose(150.0 * random.nextDouble(), 150.0 * random.nextDouble(), 0.0);
    double best = Double.POSITIVE_INFINITY;
    for (int degrees = 0; degrees < 360; degrees++) {
      Pose to = new Pose(goal.northM(), goal.eastM(), Math.toRadians(degrees));
      best = Math.min(best, Dubins.shortest(start, to, RADIUS).lengthM());
    }

    Curve way = shortest(start, goal, OptionalDouble.empty()).orElseThrow();

    assertThat(way.end(start).distanceM(goal.northM(), goal.eastM())).isLessThan(1.0e-3);
    assertThat(way.lengthM()).isLessThan(best + 1.0e-3);
  }

  @ParameterizedTest
  @ValueSource(doubles = {99.0, 99.99, 100.0, 100.01, 101.0})
  void shortest_uTurnBetweenLegsATurningCircleApart_isHalfACircleOrLittleMore(double apartM) {
    Pose goal = new Pose(0.0, apartM, Math.PI);
    Curve way = shortest(new Pose(0.0, 0.0, 0.0), goal, OptionalDouble.of(Math.PI)).orElseThrow();
    assertThat(way.lengthM()).isBetween(Math.PI * RADIUS - 1.0, 1.15 * Math.PI * RADIUS);
  }

  @Test
  void shortest_corridorWithACorner_staysInside() {
    PlanarShape corridor =
        new PlanarShape(
            "C",
            PlanarShape.Kind.AREA,
            new double[] {-100.0, 1000.0, 1000.0, 700.0, 700.0, -100.0},
            new double[] {-100.0, -100.0, 900.0, 900.0, 200.0, 200.0},
            0.0,
            Double.NEGATIVE_INFINITY,
            Double.POSITIVE_INFINITY);
    Pose start = new Pose(0.0, 0.0, 0.0);

    Curve way =
        TangentGraph.shortest(
                List.of(),
                List.of(corridor),
                CLEARANCE,
                start,
                850.0,
                800.0,
                OptionalDouble.empty(),
                RADIUS)
            .orElseThrow();

    assertThat(way.sampled(start, 1.0))
        .allMatch(s -> corridor.distanceM(s.pose().northM(), s.pose().eastM()) < 1.0);
    assertThat(way.lengthM()).isLessThan(1420.0); // 1346 m around the corner itself
  }

  @Test
  void shortest_keepOutZoneAcross_isFlownAround() {
    PlanarShape zone =
        new PlanarShape(
            "Z",
            PlanarShape.Kind.AREA,
            new double[] {400.0, 600.0, 600.0, 400.0},
            new double[] {-300.0, -300.0, 200.0, 200.0},
            0.0,
            Double.NEGATIVE_INFINITY,
            Double.POSITIVE_INFINITY);
    Pose start = new Pose(0.0, 0.0, 0.0);

    Curve way =
        TangentGraph.shortest(
                List.of(zone),
                List.of(),
                CLEARANCE,
                start,
                1000.0,
                0.0,
                OptionalDouble.empty(),
                RADIUS)
            .orElseThrow();

    assertThat(way.sampled(start, 1.0))
        .allMatch(s -> zone.distanceM(s.pose().northM(), s.pose().eastM()) > 0.93 * CLEARANCE);
    assertThat(way.lengthM()).isLessThan(1200.0);
  }

  /** Points of an arc of 6° are 84 m apart: a wall fits between them. */
  @Property(tries = 100)
  void shortest_wideTurnsAmongWalls_doNotPassThroughThem(@ForAll long seed) {
    Random random = new Random(seed);
    List<PlanarShape> walls = new ArrayList<>();
    for (int i = 0; i < 6; i++) {
      double north = 1500.0 * random.nextDouble() + 200.0;
      double east = 2500.0 * random.nextDouble() + 100.0;
      double heading = 6.0 * random.nextDouble();
      walls.add(
          new PlanarShape(
              "W" + i,
              PlanarShape.Kind.CHAIN,
              new double[] {north, north + 300.0 * Math.cos(heading)},
              new double[] {east, east + 300.0 * Math.sin(heading)},
              0.0,
              Double.NEGATIVE_INFINITY,
              Double.POSITIVE_INFINITY));
    }
    Pose start = new Pose(0.0, 0.0, 0.0);
    Optional<Curve> way =
        TangentGraph.shortest(
            walls, List.of(), CLEARANCE, start, 400.0, 3000.0, OptionalDouble.of(Math.PI), 800.0);

    way.ifPresent(
        curve ->
            assertThat(curve.sampled(start, 2.0))
                .allMatch(
                    sample ->
                        walls.stream()
                            .allMatch(
                                wall ->
                                    wall.distanceM(sample.pose().northM(), sample.pose().eastM())
                                        > 0.93 * CLEARANCE)));
  }
}
