package org.u2sa.vision.lane;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Point;

/** How gaps in painted lines are closed, and where lines go on. */
class LineGapsTest {
  private static final double LANE_M = 2.0;
  private static final double WIDEST_M = 6.1;

  private final PaintedLines paint = new PaintedLines();

  private List<List<Point>> gaps(
      LineGaps.Reach reach, LineGaps.Looked looked, LineGaps.Driven driven) {
    LineGaps gaps = new LineGaps(paint.lines(), reach, looked, driven);
    List<List<Point>> all = new ArrayList<>();
    gaps.joined().forEach(joint -> all.add(joint.points()));
    gaps.extended().forEach(extension -> all.add(extension.points()));
    return all;
  }

  private List<List<Point>> gaps(double longest, double alone) {
    return gaps(
        new LineGaps.Reach(longest, alone, alone, LANE_M, WIDEST_M),
        (x, y) -> false,
        (a, b) -> false);
  }

  private List<List<Point>> lane(double alone, double beside) {
    return gaps(
        new LineGaps.Reach(0.0, alone, beside, LANE_M, WIDEST_M), (x, y) -> false, (a, b) -> false);
  }

  private static boolean touches(List<Point> line, double x, double y) {
    return line.stream().anyMatch(p -> Math.hypot(p.x() - x, p.y() - y) < 0.2);
  }

  private static List<Point> from(List<List<Point>> gaps, double x, double y) {
    return gaps.stream()
        .filter(gap -> Math.hypot(gap.get(0).x() - x, gap.get(0).y() - y) < 0.2)
        .findFirst()
        .orElseThrow();
  }

  @Test
  void gaps_dashesInLine_areJoined() {
    paint.lookThrice(0.0, 1.0, 3.0, 1.0, 7.0, 1.0, 10.0, 1.0);
    assertThat(gaps(5.0, 0.0))
        .singleElement()
        .satisfies(gap -> assertThat(PaintedLines.length(gap)).isBetween(4.0, 4.3));
  }

  @Test
  void gaps_longerThanAllowed_stayOpen() {
    paint.lookThrice(0.0, 1.0, 3.0, 1.0, 8.5, 1.0, 10.0, 1.0);
    assertThat(gaps(5.0, 0.0)).isEmpty();
  }

  @Test
  void gaps_bothSidesOfALaneThatEnds_stayOpen() {
    paint.lookThrice(0.0, 1.6, 3.0, 1.6, 0.0, -1.6, 3.0, -1.6);
    assertThat(gaps(5.0, 0.0)).isEmpty();
  }

  @Test
  void gaps_endBetweenTwoOthers_isJoinedToTheOneInLine() {
    paint.lookThrice(0.0, 0.0, 3.0, 0.0, 7.0, 0.1, 10.0, 0.1, 7.0, 2.0, 10.0, 2.0);
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
    paint.lookThrice(arc);
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
    paint.lookThrice(0.0, 0.0, 6.0, 0.0, 2.0, 0.38, 4.0, 0.38, 7.0, 1.5, 8.0, 2.0);
    assertThat(paint.lines()).hasSize(3);
    assertThat(gaps(5.0, 0.0)).noneMatch(gap -> touches(gap, 4.0, 0.38));
  }

  @Test
  void gaps_openEnds_goOnForTheExtension() {
    paint.lookThrice(0.0, 0.0, 3.0, 0.0);
    assertThat(gaps(5.0, 1.2))
        .hasSize(2)
        .allSatisfy(gap -> assertThat(PaintedLines.length(gap)).isCloseTo(1.2, offset(1.0e-6)));
  }

  @Test
  void gaps_groundBeyondTheEndLookedAt_lineEndsThere() {
    paint.lookThrice(-4.0, 1.0, 0.0, 1.0);
    LineGaps.Reach reach = new LineGaps.Reach(5.0, 1.2, 1.2, LANE_M, WIDEST_M);
    List<List<Point>> ahead = gaps(reach, (x, y) -> x > 0.0, (a, b) -> false);
    assertThat(ahead)
        .singleElement()
        .satisfies(gap -> assertThat(gap.get(gap.size() - 1).x()).isLessThan(-4.0));
  }

  @Test
  void gaps_groundBeyondTheEndLookedAtLessFarThanAGap_goOn() {
    paint.lookThrice(-4.0, 1.0, 0.0, 1.0);
    LineGaps.Reach reach = new LineGaps.Reach(5.0, 1.2, 1.2, LANE_M, WIDEST_M);
    assertThat(gaps(reach, (x, y) -> x > 0.0 && x < 3.0, (a, b) -> false)).hasSize(2);
  }

  @Test
  void gaps_besideTheLineOfAnotherLane_endWhereTheGroundWasLookedAt() {
    paint.lookThrice(-6.0, 1.0, 8.0, 1.0, -6.0, -2.5, 0.0, -2.5);
    LineGaps.Reach reach = new LineGaps.Reach(5.0, 1.2, 6.0, LANE_M, WIDEST_M);
    assertThat(gaps(reach, (x, y) -> false, (a, b) -> false))
        .anySatisfy(gap -> assertThat(gap.get(gap.size() - 1).x()).isGreaterThan(5.0));
    assertThat(gaps(reach, (x, y) -> x > 0.0 && y < 0.0, (a, b) -> false))
        .noneSatisfy(
            gap -> {
              assertThat(gap.get(0).y()).isNegative();
              assertThat(gap.get(gap.size() - 1).x()).isGreaterThan(0.5);
            });
  }

  @Test
  void gaps_besideTheLineOfTheDrivenLane_goOnWhereTheGroundWasLookedAt() {
    paint.lookThrice(-6.0, 1.0, 8.0, 1.0, -6.0, -2.5, 0.0, -2.5);
    DrivenWay way = new DrivenWay();
    for (double x = -5.0; x < -1.0; x += 0.5) {
      way.at(Point.of(x, -0.8, 0.0));
    }
    LineGaps.Reach reach = new LineGaps.Reach(5.0, 1.2, 6.0, LANE_M, WIDEST_M);
    assertThat(gaps(reach, (x, y) -> true, way::passesBetween))
        .anySatisfy(
            gap -> {
              assertThat(gap.get(0).y()).isNegative();
              assertThat(gap.get(gap.size() - 1).x()).isGreaterThan(5.0);
            });
  }

  @Test
  void gaps_bothSidesOfTheDrivenLaneEnd_endWhereTheGroundWasLookedAt() {
    paint.lookThrice(-6.0, 1.0, 0.0, 1.0, -6.0, -2.5, 0.0, -2.5);
    DrivenWay way = new DrivenWay();
    for (double x = -5.0; x < -1.0; x += 0.5) {
      way.at(Point.of(x, -0.8, 0.0));
    }
    LineGaps.Reach reach = new LineGaps.Reach(5.0, 1.2, 6.0, LANE_M, WIDEST_M);
    assertThat(gaps(reach, (x, y) -> true, way::passesBetween)).isEmpty();
  }

  @Test
  void gaps_endPassedOnAnotherWay_endsWhereTheGroundWasLookedAt() {
    paint.lookThrice(1.5, 0.0, 1.5, -1.5, -2.0, 3.0, -2.0, -10.0);
    DrivenWay way = new DrivenWay();
    for (double y = 3.0; y > -3.0; y -= 0.5) {
      way.at(Point.of(-0.5, y, 0.0));
    }
    LineGaps.Reach reach = new LineGaps.Reach(5.0, 1.2, 6.0, LANE_M, WIDEST_M);
    assertThat(gaps(reach, (x, y) -> true, way::passesBetween)).isEmpty();
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
  void gaps_extensionTowardsAnotherLine_leavesALane() {
    paint.lookThrice(0.0, 0.0, 3.0, 0.0, 5.5, -2.0, 5.5, 2.0);
    assertThat(gaps(0.0, 4.0))
        .filteredOn(gap -> Math.abs(gap.get(0).y()) < 0.5 && gap.get(0).x() > 2.0)
        .allSatisfy(
            gap -> assertThat(gap).allSatisfy(p -> assertThat(p.x()).isLessThan(5.5 - LANE_M)));
  }

  @Test
  void gaps_endBesideTheOtherLineOfItsLane_goesOnAsFarAsThatIsKnown() {
    paint.lookThrice(0.0, 2.0, 3.0, 2.0, 0.0, -2.0, 8.0, -2.0);
    List<Point> gap = from(lane(1.2, 6.0), 3.0, 2.0);
    assertThat(PaintedLines.length(gap)).isBetween(4.6, 5.2);
    assertThat(gap).allSatisfy(p -> assertThat(p.y()).isCloseTo(2.0, offset(0.05)));
  }

  @Test
  void gaps_besideALongLine_goOnNoFartherThanAllowed() {
    paint.lookThrice(0.0, 2.0, 3.0, 2.0, 0.0, -2.0, 20.0, -2.0);
    assertThat(PaintedLines.length(from(lane(1.2, 6.0), 3.0, 2.0))).isBetween(5.8, 6.3);
  }

  @Test
  void gaps_besideALineTooFarAway_goOnAlone() {
    paint.lookThrice(0.0, 4.5, 3.0, 4.5, 0.0, -2.0, 8.0, -2.0);
    assertThat(PaintedLines.length(from(lane(1.2, 6.0), 3.0, 4.5))).isCloseTo(1.2, offset(1.0e-6));
  }

  @Test
  void gaps_besideALineTooNear_goOnAlone() {
    paint.lookThrice(0.0, -0.2, 3.0, -0.2, 0.0, -2.0, 8.0, -2.0);
    assertThat(lane(0.3, 6.0))
        .allSatisfy(gap -> assertThat(PaintedLines.length(gap)).isLessThan(0.31));
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
    paint.lookThrice(ends);
    List<Point> gap = from(lane(1.2, 6.0), 0.0, -5.5);
    assertThat(PaintedLines.length(gap)).isGreaterThan(4.0);
    assertThat(gap)
        .allSatisfy(p -> assertThat(Math.hypot(p.x(), p.y())).isCloseTo(5.5, offset(0.3)));
  }

  @Test
  void gaps_besideALineInDashes_goOnBesideAllOfThem() {
    paint.lookThrice(
        -6.0, 2.0, 1.0, 2.0, -6.0, -2.0, -1.0, -2.0, 1.0, -2.0, 3.0, -2.0, 5.0, -2.0, 9.0, -2.0);
    LineGaps.Reach reach = new LineGaps.Reach(3.0, 0.6, 6.0, LANE_M, WIDEST_M);
    List<Point> gap = from(gaps(reach, (x, y) -> false, (a, b) -> false), 1.0, 2.0);
    assertThat(gap.get(gap.size() - 1).x()).isGreaterThan(6.5);
  }

  @Test
  void gaps_innerLineOfASwitchback_closeWhereTheOuterOneLeads() {
    paint.lookThrice(
        concat(
            PaintedLines.arc(6.0, -1.8, 1.8, 60),
            PaintedLines.arc(1.8, -1.9, -1.3, 4),
            PaintedLines.arc(1.8, 1.3, 1.9, 4)));
    List<List<Point>> gaps =
        gaps(new LineGaps.Reach(5.2, 0.5, 6.0, LANE_M, WIDEST_M), (x, y) -> false, (a, b) -> false);
    for (double angle = -1.3; angle <= 1.3; angle += 0.1) { // ends turn by 74° into the gap
      Point at = Point.of(1.8 * Math.cos(angle), 1.8 * Math.sin(angle), 0.0);
      assertThat(gaps)
          .as("the inner line at %.1f rad", angle)
          .anySatisfy(gap -> assertThat(nearest(at, gap)).isLessThan(0.5));
    }
  }

  @Test
  void beside_sameSideBeginsAgain_leadsToItsEnd() {
    paint.lookThrice(-6.0, 2.0, 12.0, 2.0, -6.0, -2.0, 0.0, -2.0, 3.0, -2.5, 8.0, -2.5);
    List<List<Point>> lines = paint.lines();
    LineGaps.Reach reach = new LineGaps.Reach(5.2, 1.2, 6.0, LANE_M, WIDEST_M);
    List<Point> own =
        lines.stream().filter(line -> Math.abs(line.get(0).y() + 2.0) < 0.1).findFirst().get();
    boolean leadsOut = own.get(0).x() < own.get(own.size() - 1).x();
    LineEnd end = leadsOut ? LineEnd.last(own) : LineEnd.first(own);
    List<Point> beside = new LanePartner(lines, reach, (a, b) -> false).beside(end).points();
    Point last = beside.get(beside.size() - 1);
    assertThat(last.x()).isCloseTo(3.0, offset(0.2));
    assertThat(last.y()).isCloseTo(-2.5, offset(0.05));
  }

  @Test
  void gaps_lineSeenAgainAsideAfterAJump_goOnFromItsFarthestEnd() {
    // The same line, 0.7 m beside where it was before the position jumped, and seen farther.
    paint.lookThrice(-6.0, 2.0, 12.0, 2.0, -6.0, -2.0, 0.0, -2.0, -1.0, -2.7, 1.4, -2.7);
    List<Point> beside = from(lane(1.2, 6.0), 1.4, -2.7);
    assertThat(beside.get(beside.size() - 1).x()).isCloseTo(7.4, offset(0.3));
    assertThat(beside).allSatisfy(p -> assertThat(p.y()).isCloseTo(-2.7, offset(0.05)));
    assertThat(PaintedLines.length(from(lane(1.2, 1.2), 1.4, -2.7)))
        .as("without the other line of the lane")
        .isCloseTo(1.2, offset(1.0e-6));
  }

  @Test
  void onward_besideTheLineBeyondTheVehicle_goesOnAsFarAsAllowed() {
    paint.lookThrice(-6.0, 2.0, 12.0, 2.0, -6.0, -5.0, 12.0, -5.0);
    LineGaps gaps =
        new LineGaps(
            paint.lines(),
            new LineGaps.Reach(5.2, 1.2, 6.0, LANE_M, WIDEST_M),
            (x, y) -> false,
            (a, b) -> false);
    List<Point> side = List.of(Point.of(-1.0, -2.0, 0.0), Point.of(0.0, -2.0, 0.0));
    List<Point> onward = gaps.onward(side, Point.of(0.0, 0.0, 0.0));
    assertThat(PaintedLines.length(onward)).isBetween(5.8, 6.3);
    assertThat(onward).allSatisfy(p -> assertThat(p.y()).isCloseTo(-2.0, offset(0.05)));
    assertThat(gaps.onward(side, Point.of(0.0, -3.5, 0.0)))
        .as("beside the line on the vehicle's other side")
        .allSatisfy(p -> assertThat(p.y()).isCloseTo(-2.0, offset(0.05)));
    assertThat(gaps.onward(side, Point.of(1.0, -2.0, 0.0))).as("no line across").isEmpty();
  }

  @Test
  void isLaneSide_alongALaneOrAcrossIt_isOrIsNot() {
    paint.lookThrice(0.0, 2.0, 8.0, 2.0, 1.0, -2.0, 5.0, -2.0, 4.0, -1.0, 4.0, 1.0);
    List<List<Point>> lines = paint.lines();
    LineGaps gaps =
        new LineGaps(
            lines,
            new LineGaps.Reach(5.2, 1.2, 6.0, LANE_M, WIDEST_M),
            (x, y) -> false,
            (a, b) -> false);
    assertThat(lines)
        .hasSize(3)
        .allSatisfy(
            line -> {
              boolean across = Math.abs(line.get(0).y() - line.get(line.size() - 1).y()) > 1.0;
              assertThat(gaps.isLaneSide(line, line)).isEqualTo(!across);
            });
  }

  private static double nearest(Point at, List<Point> line) {
    return LineGeometry.metres(at, line.get(LineGeometry.nearest(at, line)));
  }

  private static double[] concat(double[]... all) {
    return Arrays.stream(all).flatMapToDouble(Arrays::stream).toArray();
  }
}
