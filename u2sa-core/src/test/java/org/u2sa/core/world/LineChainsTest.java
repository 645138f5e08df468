package org.u2sa.core.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Point;

/** Beads of painted lines: how they are seen, strung, doubted, and how gaps are closed. */
class LineChainsTest {
  private static final double LANE_M = 2.0;

  private final LineBeads beads = new LineBeads();
  private long micros;

  private void look(double... ends) {
    beads.begin(micros += 100_000);
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
    assertThat(chains().gaps(5.0, 0.0))
        .singleElement()
        .satisfies(gap -> assertThat(length(gap)).isBetween(4.0, 4.3));
  }

  @Test
  void gaps_longerThanAllowed_stayOpen() {
    lookThrice(0.0, 1.0, 3.0, 1.0, 8.5, 1.0, 10.0, 1.0);
    assertThat(chains().gaps(5.0, 0.0)).isEmpty();
  }

  @Test
  void gaps_bothSidesOfALaneThatEnds_stayOpen() {
    lookThrice(0.0, 1.6, 3.0, 1.6, 0.0, -1.6, 3.0, -1.6);
    assertThat(chains().gaps(5.0, 0.0)).isEmpty();
  }

  @Test
  void gaps_endBetweenTwoOthers_isJoinedToTheOneInLine() {
    lookThrice(0.0, 0.0, 3.0, 0.0, 7.0, 0.1, 10.0, 0.1, 7.0, 2.0, 10.0, 2.0);
    assertThat(chains().gaps(5.0, 0.0))
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
    assertThat(chains().gaps(5.0, 0.0))
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
    assertThat(chains().gaps(5.0, 0.0)).noneMatch(gap -> touches(gap, 4.0, 0.38));
  }

  private static boolean touches(List<Point> line, double x, double y) {
    return line.stream().anyMatch(p -> Math.hypot(p.x() - x, p.y() - y) < 0.2);
  }

  @Test
  void gaps_openEnds_goOnForTheExtension() {
    lookThrice(0.0, 0.0, 3.0, 0.0);
    assertThat(chains().gaps(5.0, 1.2))
        .hasSize(2)
        .allSatisfy(gap -> assertThat(length(gap)).isCloseTo(1.2, offset(1.0e-6)));
  }

  @Test
  void gaps_extensionTowardsAnotherLine_leavesALane() {
    lookThrice(0.0, 0.0, 3.0, 0.0, 5.5, -2.0, 5.5, 2.0);
    assertThat(chains().gaps(0.0, 4.0))
        .filteredOn(gap -> Math.abs(gap.get(0).y()) < 0.5 && gap.get(0).x() > 2.0)
        .allSatisfy(
            gap -> assertThat(gap).allSatisfy(p -> assertThat(p.x()).isLessThan(5.5 - LANE_M)));
  }

  @Test
  void doubt_lineAheadNotSeenAnyMore_goes() {
    lookThrice(1.5, 0.0, 2.4, 0.0);
    for (int i = 0; i < 8; i++) {
      beads.begin(micros += 100_000);
      beads.doubt(0.0, 0.0, 0.0, 2.5, 0.5);
      beads.forget(0.0, 0.0, 50.0, micros - 3_000_000, 3);
    }
    assertThat(beads.count()).isZero();
  }

  @Test
  void doubt_lineBesideTheVehicle_stays() {
    lookThrice(0.0, 2.0, 2.0, 2.0);
    int before = beads.count();
    for (int i = 0; i < 8; i++) {
      beads.begin(micros += 100_000);
      beads.doubt(0.0, 0.0, 0.0, 2.5, 0.5);
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
}
