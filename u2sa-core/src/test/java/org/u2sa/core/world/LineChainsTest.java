package org.u2sa.core.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Point;

/** Beads of painted lines: how they are seen, strung, doubted, and how gaps are closed. */
class LineChainsTest {
  private static final double LANE_M = 2.0;
  private static final double WIDEST_M = 6.1;
  private static final double WANDER = 0.0025; // 5 cm in a second

  private final LineBeads beads = new LineBeads();
  private long micros;

  private void look(double... ends) {
    beads.begin(micros += 100_000, WANDER);
    for (int i = 0; i < ends.length; i += 4) {
      beads.enter(
          Point.of(ends[i], ends[i + 1], 0.0), Point.of(ends[i + 2], ends[i + 3], 0.0), 0.05, 0.35);
    }
  }

  private void lookThrice(double... ends) {
    for (int i = 0; i < 3; i++) {
      look(ends);
    }
  }

  private LineChains chains() {
    return LineChains.of(beads.certain(0.0, 0.0, 50.0, 3), LANE_M);
  }

  private List<List<Point>> gaps(double longest, double alone) {
    return chains()
        .gaps(
            new LineChains.Reach(longest, alone, alone, WIDEST_M),
            (x, y) -> false,
            (a, b) -> false);
  }

  private List<List<Point>> lane(double alone, double beside) {
    return chains()
        .gaps(new LineChains.Reach(0.0, alone, beside, WIDEST_M), (x, y) -> false, (a, b) -> false);
  }

  private static double length(List<Point> line) {
    Point a = line.get(0);
    Point b = line.get(line.size() - 1);
    return Math.hypot(a.x() - b.x(), a.y() - b.y());
  }

  @Test
  void lines_straightLineSeenThrice_isOneChainOfItsLength() {
    lookThrice(0.0, 1.0, 4.0, 1.0);
    assertThat(chains().lines())
        .singleElement()
        .satisfies(line -> assertThat(length(line)).isCloseTo(4.0, offset(0.2)))
        .satisfies(
            line ->
                assertThat(line).allSatisfy(p -> assertThat(p.y()).isCloseTo(1.0, offset(1e-9))));
  }

  @Test
  void lines_seenTwice_areNotCertain() {
    look(0.0, 1.0, 4.0, 1.0);
    look(0.0, 1.0, 4.0, 1.0);
    assertThat(chains().lines()).isEmpty();
  }

  @Test
  void lines_seenInTwoPiecesOfOnePicture_areOneSightingEach() {
    look(0.0, 1.0, 4.0, 1.0, 0.0, 1.0, 4.0, 1.0, 0.0, 1.0, 4.0, 1.0);
    assertThat(chains().lines()).isEmpty();
  }

  @Test
  void lines_seenFromOtherDirection_areTheSameLine() {
    look(0.0, 1.0, 4.0, 1.0);
    look(4.0, 1.0, 0.0, 1.0);
    look(0.0, 1.0, 4.0, 1.0);
    assertThat(chains().lines()).hasSize(1);
  }

  @Test
  void enter_displacedSighting_movesTheLineTowardsIt() {
    look(0.0, 1.0, 4.0, 1.0);
    look(0.0, 1.2, 4.0, 1.2);
    look(0.0, 1.2, 4.0, 1.2);
    assertThat(chains().lines())
        .singleElement()
        .satisfies(line -> assertThat(line).allSatisfy(p -> assertThat(p.y()).isBetween(1.1, 1.2)));
  }

  @Test
  void enter_lineBeyondTheGate_isAnotherLine() {
    lookThrice(0.0, 1.0, 4.0, 1.0, 0.0, 1.6, 4.0, 1.6);
    assertThat(chains().lines()).hasSize(2);
  }

  @Test
  void lines_crossing_areTwo() {
    lookThrice(0.0, 0.0, 4.0, 0.0, 2.0, -2.0, 2.0, 2.0);
    assertThat(chains().lines().size()).isGreaterThanOrEqualTo(2);
  }

  @Test
  void gaps_dashesInLine_areJoined() {
    lookThrice(0.0, 1.0, 3.0, 1.0, 7.0, 1.0, 10.0, 1.0);
    assertThat(gaps(5.0, 0.0))
        .singleElement()
        .satisfies(gap -> assertThat(length(gap)).isBetween(4.0, 4.3));
  }

  @Test
  void gaps_longerThanAllowed_stayOpen() {
    lookThrice(0.0, 1.0, 3.0, 1.0, 8.5, 1.0, 10.0, 1.0);
    assertThat(gaps(5.0, 0.0)).isEmpty();
  }

  @Test
  void gaps_bothSidesOfALaneThatEnds_stayOpen() {
    lookThrice(0.0, 1.6, 3.0, 1.6, 0.0, -1.6, 3.0, -1.6);
    assertThat(gaps(5.0, 0.0)).isEmpty();
  }

  @Test
  void gaps_endBetweenTwoOthers_isJoinedToTheOneInLine() {
    lookThrice(0.0, 0.0, 3.0, 0.0, 7.0, 0.1, 10.0, 0.1, 7.0, 2.0, 10.0, 2.0);
    assertThat(gaps(5.0, 0.0))
        .singleElement()
        .satisfies(gap -> assertThat(gap).allSatisfy(p -> assertThat(p.y()).isBetween(-0.1, 0.2)));
  }

  @Test
  void gaps_inACurve_bulgeAsTheLineDoes() {
    double[] arc = new double[4 * 20];
    for (int i = 0; i < 20; i++) { // a quarter circle of 5 m with a gap in its middle
      double from = (i < 10 ? i : i + 8) * Math.PI / 56.0;
      double to = from + Math.PI / 56.0;
      arc[4 * i] = 5.0 * Math.cos(from);
      arc[4 * i + 1] = 5.0 * Math.sin(from);
      arc[4 * i + 2] = 5.0 * Math.cos(to);
      arc[4 * i + 3] = 5.0 * Math.sin(to);
    }
    lookThrice(arc);
    assertThat(gaps(5.0, 0.0))
        .singleElement()
        .satisfies(
            gap ->
                assertThat(gap)
                    .allSatisfy(
                        p -> assertThat(Math.hypot(p.x(), p.y())).isCloseTo(5.0, offset(0.1))));
  }

  @Test
  void gaps_lineSeenTwiceBesideALongerOne_doesNotLeadAway() {
    // The short one is a part of the long one, seen while the vehicle turned.
    lookThrice(0.0, 0.0, 6.0, 0.0, 2.0, 0.38, 4.0, 0.38, 7.0, 1.5, 8.0, 2.0);
    assertThat(chains().lines()).hasSize(3);
    assertThat(gaps(5.0, 0.0)).noneMatch(gap -> touches(gap, 4.0, 0.38));
  }

  private static boolean touches(List<Point> line, double x, double y) {
    return line.stream().anyMatch(p -> Math.hypot(p.x() - x, p.y() - y) < 0.2);
  }

  @Test
  void gaps_openEnds_goOnForTheExtension() {
    lookThrice(0.0, 0.0, 3.0, 0.0);
    assertThat(gaps(5.0, 1.2))
        .hasSize(2)
        .allSatisfy(gap -> assertThat(length(gap)).isCloseTo(1.2, offset(1.0e-6)));
  }

  @Test
  void gaps_groundBeyondTheEndLookedAt_lineEndsThere() {
    lookThrice(-4.0, 1.0, 0.0, 1.0);
    LineChains.Reach reach = new LineChains.Reach(5.0, 1.2, 1.2, WIDEST_M);
    List<List<Point>> ahead = chains().gaps(reach, (x, y) -> x > 0.0, (a, b) -> false);
    assertThat(ahead)
        .singleElement()
        .satisfies(gap -> assertThat(gap.get(gap.size() - 1).x()).isLessThan(-4.0));
  }

  @Test
  void gaps_groundBeyondTheEndLookedAtLessFarThanAGap_goOn() {
    lookThrice(-4.0, 1.0, 0.0, 1.0);
    LineChains.Reach reach = new LineChains.Reach(5.0, 1.2, 1.2, WIDEST_M);
    assertThat(chains().gaps(reach, (x, y) -> x > 0.0 && x < 3.0, (a, b) -> false)).hasSize(2);
  }

  @Test
  void gaps_besideTheLineOfAnotherLane_endWhereTheGroundWasLookedAt() {
    lookThrice(-6.0, 1.0, 8.0, 1.0, -6.0, -2.5, 0.0, -2.5);
    LineChains.Reach reach = new LineChains.Reach(5.0, 1.2, 6.0, WIDEST_M);
    assertThat(chains().gaps(reach, (x, y) -> false, (a, b) -> false))
        .anySatisfy(gap -> assertThat(gap.get(gap.size() - 1).x()).isGreaterThan(5.0));
    assertThat(chains().gaps(reach, (x, y) -> x > 0.0 && y < 0.0, (a, b) -> false))
        .noneSatisfy(
            gap -> {
              assertThat(gap.get(0).y()).isNegative();
              assertThat(gap.get(gap.size() - 1).x()).isGreaterThan(0.5);
            });
  }

  @Test
  void gaps_besideTheLineOfTheDrivenLane_goOnWhereTheGroundWasLookedAt() {
    lookThrice(-6.0, 1.0, 8.0, 1.0, -6.0, -2.5, 0.0, -2.5);
    DrivenWay way = new DrivenWay();
    for (double x = -5.0; x < -1.0; x += 0.5) {
      way.at(Point.of(x, -0.8, 0.0));
    }
    LineChains.Reach reach = new LineChains.Reach(5.0, 1.2, 6.0, WIDEST_M);
    assertThat(chains().gaps(reach, (x, y) -> true, way::passesBetween))
        .anySatisfy(
            gap -> {
              assertThat(gap.get(0).y()).isNegative();
              assertThat(gap.get(gap.size() - 1).x()).isGreaterThan(5.0);
            });
  }

  @Test
  void gaps_bothSidesOfTheDrivenLaneEnd_endWhereTheGroundWasLookedAt() {
    lookThrice(-6.0, 1.0, 0.0, 1.0, -6.0, -2.5, 0.0, -2.5);
    DrivenWay way = new DrivenWay();
    for (double x = -5.0; x < -1.0; x += 0.5) {
      way.at(Point.of(x, -0.8, 0.0));
    }
    LineChains.Reach reach = new LineChains.Reach(5.0, 1.2, 6.0, WIDEST_M);
    assertThat(chains().gaps(reach, (x, y) -> true, way::passesBetween)).isEmpty();
  }

  @Test
  void gaps_endPassedOnAnotherWay_endsWhereTheGroundWasLookedAt() {
    lookThrice(1.5, 0.0, 1.5, -1.5, -2.0, 3.0, -2.0, -10.0);
    DrivenWay way = new DrivenWay();
    for (double y = 3.0; y > -3.0; y -= 0.5) {
      way.at(Point.of(-0.5, y, 0.0));
    }
    LineChains.Reach reach = new LineChains.Reach(5.0, 1.2, 6.0, WIDEST_M);
    assertThat(chains().gaps(reach, (x, y) -> true, way::passesBetween)).isEmpty();
  }

  @Test
  void drivenWay_besideBothPlaces_doesNotPassBetweenThem() {
    DrivenWay way = new DrivenWay();
    way.at(Point.of(0.0, 0.0, 0.0));
    way.at(Point.of(4.0, 0.0, 0.0));
    assertThat(way.passesBetween(Point.of(2.0, 1.0, 0.0), Point.of(2.0, -1.0, 0.0))).isTrue();
    assertThat(way.passesBetween(Point.of(2.0, 1.0, 0.0), Point.of(2.0, 3.0, 0.0))).isFalse();
    assertThat(way.passesBetween(Point.of(5.0, 1.0, 0.0), Point.of(5.0, -1.0, 0.0))).isFalse();
  }

  @Test
  void doubt_lineBehindWhatStands_stays() {
    lookThrice(1.5, 0.0, 2.4, 0.0);
    int before = beads.count();
    for (int i = 0; i < 8; i++) {
      beads.begin(micros += 100_000, 0.0);
      beads.doubt(0.0, 0.0, 0.0, 2.5, 0.5, (x, y) -> x < 1.0);
      beads.forget(0.0, 0.0, 50.0, micros - 3_000_000, 3);
    }
    assertThat(beads.count()).isEqualTo(before);
  }

  @Test
  void gaps_extensionTowardsAnotherLine_leavesALane() {
    lookThrice(0.0, 0.0, 3.0, 0.0, 5.5, -2.0, 5.5, 2.0);
    assertThat(gaps(0.0, 4.0))
        .filteredOn(gap -> Math.abs(gap.get(0).y()) < 0.5 && gap.get(0).x() > 2.0)
        .allSatisfy(
            gap -> assertThat(gap).allSatisfy(p -> assertThat(p.x()).isLessThan(5.5 - LANE_M)));
  }

  @Test
  void doubt_lineAheadNotSeenAnyMore_goes() {
    lookThrice(1.5, 0.0, 2.4, 0.0);
    for (int i = 0; i < 8; i++) {
      beads.begin(micros += 100_000, 0.0);
      beads.doubt(0.0, 0.0, 0.0, 2.5, 0.5, (x, y) -> true);
      beads.forget(0.0, 0.0, 50.0, micros - 3_000_000, 3);
    }
    assertThat(beads.count()).isZero();
  }

  @Test
  void doubt_lineBesideTheVehicle_stays() {
    lookThrice(0.0, 2.0, 2.0, 2.0);
    int before = beads.count();
    for (int i = 0; i < 8; i++) {
      beads.begin(micros += 100_000, 0.0);
      beads.doubt(0.0, 0.0, 0.0, 2.5, 0.5, (x, y) -> true);
      beads.forget(0.0, 0.0, 50.0, micros - 3_000_000, 3);
    }
    assertThat(beads.count()).isEqualTo(before);
  }

  @Test
  void forget_seenOnceLongAgoOrFarAway_goes() {
    look(0.0, 0.0, 1.0, 0.0);
    lookThrice(20.0, 0.0, 21.0, 0.0);
    beads.forget(0.0, 0.0, 10.0, micros, 3);
    assertThat(beads.count()).isZero();
  }

  private static List<Point> from(List<List<Point>> gaps, double x, double y) {
    return gaps.stream()
        .filter(gap -> Math.hypot(gap.get(0).x() - x, gap.get(0).y() - y) < 0.2)
        .findFirst()
        .orElseThrow();
  }

  @Test
  void gaps_endBesideTheOtherLineOfItsLane_goesOnAsFarAsThatIsKnown() {
    lookThrice(0.0, 2.0, 3.0, 2.0, 0.0, -2.0, 8.0, -2.0);
    List<Point> gap = from(lane(1.2, 6.0), 3.0, 2.0);
    assertThat(length(gap)).isBetween(4.6, 5.2);
    assertThat(gap).allSatisfy(p -> assertThat(p.y()).isCloseTo(2.0, offset(0.05)));
  }

  @Test
  void gaps_besideALongLine_goOnNoFartherThanAllowed() {
    lookThrice(0.0, 2.0, 3.0, 2.0, 0.0, -2.0, 20.0, -2.0);
    assertThat(length(from(lane(1.2, 6.0), 3.0, 2.0))).isBetween(5.8, 6.3);
  }

  @Test
  void gaps_besideALineTooFarAway_goOnAlone() {
    lookThrice(0.0, 4.5, 3.0, 4.5, 0.0, -2.0, 8.0, -2.0);
    assertThat(length(from(lane(1.2, 6.0), 3.0, 4.5))).isCloseTo(1.2, offset(1.0e-6));
  }

  @Test
  void gaps_besideALineTooNear_goOnAlone() {
    lookThrice(0.0, -0.2, 3.0, -0.2, 0.0, -2.0, 8.0, -2.0);
    assertThat(lane(0.3, 6.0)).allSatisfy(gap -> assertThat(length(gap)).isLessThan(0.31));
  }

  @Test
  void gaps_besideABend_keepTheLanesWidth() {
    double[] ends = new double[4 * 21];
    for (int i = 0; i < 20; i++) { // half a circle of 2 m around the origin: the inner line
      double from = i * Math.PI / 20.0 - 0.5 * Math.PI;
      double to = from + Math.PI / 20.0;
      ends[4 * i] = 2.0 * Math.cos(from);
      ends[4 * i + 1] = 2.0 * Math.sin(from);
      ends[4 * i + 2] = 2.0 * Math.cos(to);
      ends[4 * i + 3] = 2.0 * Math.sin(to);
    }
    ends[80] = -1.0; // the outer one ends where the bend begins
    ends[81] = -5.5;
    ends[82] = 0.0;
    ends[83] = -5.5;
    lookThrice(ends);
    List<Point> gap = from(lane(1.2, 6.0), 0.0, -5.5);
    assertThat(length(gap)).isGreaterThan(4.0);
    assertThat(gap)
        .allSatisfy(p -> assertThat(Math.hypot(p.x(), p.y())).isCloseTo(5.5, offset(0.3)));
  }

  @Test
  void enter_notSeenForAMinute_isLookedForFartherAway() {
    lookThrice(0.0, 1.0, 4.0, 1.0);
    micros += 60_000_000;
    look(0.0, 1.5, 4.0, 1.5);
    assertThat(beads.certain(0.0, 0.0, 50.0, 1))
        .allSatisfy(bead -> assertThat(bead.y).isBetween(1.4, 1.5));
  }

  @Test
  void doubt_sameLineSeenBesideItsPlaceAgainAndAgain_goes() {
    lookThrice(0.0, 1.0, 4.0, 1.0);
    micros += 5_000_000;
    for (int i = 0; i < 8; i++) {
      look(0.0, 1.9, 4.0, 1.9);
      beads.doubt(0.0, 0.0, Math.PI, 2.5, 0.1, (x, y) -> true); // looks the other way
      beads.forget(0.0, 0.0, 50.0, micros - 3_000_000, 3);
    }
    assertThat(beads.certain(0.0, 0.0, 50.0, 3))
        .isNotEmpty()
        .allSatisfy(bead -> assertThat(bead.y).isGreaterThan(1.5));
  }

  @Test
  void doubt_twoLinesSeenInOnePicture_bothStay() {
    lookThrice(0.0, 1.0, 4.0, 1.0, 0.0, 1.9, 4.0, 1.9);
    micros += 5_000_000;
    look(0.0, 1.0, 4.0, 1.0, 0.0, 1.9, 4.0, 1.9);
    beads.doubt(0.0, 0.0, Math.PI, 2.5, 0.1, (x, y) -> true);
    assertThat(beads.certain(0.0, 0.0, 50.0, 4))
        .as("four sightings, no doubt")
        .hasSize(beads.count());
    for (int i = 0; i < 8; i++) {
      look(0.0, 1.0, 4.0, 1.0, 0.0, 1.9, 4.0, 1.9);
      beads.doubt(0.0, 0.0, Math.PI, 2.5, 0.1, (x, y) -> true);
      beads.forget(0.0, 0.0, 50.0, micros - 3_000_000, 3);
    }
    assertThat(chains().lines()).hasSize(2);
  }

  @Test
  void isSure_seenFromOnePlaceOnly_isNot() {
    lookThrice(0.0, 1.0, 4.0, 1.0);
    LineChains chains = chains();
    assertThat(chains.isSure(chains.lines().get(0))).isFalse();
  }

  @Test
  void isSure_seenFromThreePlaces_is() {
    for (int i = 0; i < 3; i++) {
      beads.from(0.3 * i, 0.0);
      look(0.0, 1.0, 4.0, 1.0);
    }
    LineChains chains = chains();
    assertThat(chains.isSure(chains.lines().get(0))).isTrue();
  }
}
