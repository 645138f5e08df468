package org.u2sa.vision.lane;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Point;

/** The sides of a driven lane where its lines have gaps. Lanes are 4 m wide, along x. */
class DrivenLaneTest {
  private static final LineGaps.Reach REACH = new LineGaps.Reach(5.2, 1.2, 6.0, 2.0, 6.1);

  private final DrivenLane lane = new DrivenLane();
  private final List<DrivenLane.Known> known = new ArrayList<>();

  private void line(boolean sure, double fromX, double toX, double y) {
    List<Point> points = new ArrayList<>();
    for (double x = fromX; x <= toX; x += LineSamples.STEP_M) {
      points.add(Point.of(x, y, 0.0));
    }
    known.add(new DrivenLane.Known(points, sure));
  }

  private void drive(double fromX, double toX) {
    for (double x = fromX; x <= toX; x += 0.1) {
      lane.at(Point.of(x, 0.0, 0.0), 0L);
    }
  }

  private List<Point> sides() {
    return lane.sides(known, REACH).stream().flatMap(side -> side.points().stream()).toList();
  }

  /** Whether a side runs along y from one x to another, without a hole. */
  private static boolean runs(List<Point> sides, double fromX, double toX, double y) {
    return Stream.iterate(fromX, x -> x <= toX, x -> x + 0.3)
        .allMatch(
            x ->
                sides.stream()
                    .anyMatch(p -> Math.abs(p.x() - x) < 0.4 && Math.abs(p.y() - y) < 0.15));
  }

  @Test
  void sides_bothLinesCertain_areNotRepeated() {
    line(true, -6.0, 20.0, 2.0);
    line(true, -6.0, 20.0, -2.0);
    drive(-5.0, 8.0);
    assertThat(sides()).isEmpty();
  }

  @Test
  void sides_lineSeenFromOnePlaceOnly_isASideOfTheDrivenLane() {
    line(true, -6.0, 20.0, 2.0);
    line(false, -6.0, 20.0, -2.0);
    drive(-5.0, 8.0);
    assertThat(runs(sides(), -4.0, 7.5, -2.0)).isTrue();
  }

  @Test
  void sides_oneLineEnds_theLaneKeepsItsWidth() {
    line(true, -6.0, 20.0, 2.0);
    line(true, -6.0, 0.0, -2.0);
    drive(-5.0, 8.0);
    List<Point> sides = sides();
    assertThat(runs(sides, 0.3, 7.5, -2.0)).isTrue();
    assertThat(sides).allSatisfy(p -> assertThat(p.y()).isNegative());
  }

  /** As in no-man's land, where lines of two other lanes are by chance as far apart as a lane. */
  @Test
  void sides_certainLineSeenLaterAndNearer_lieNotBeyondIt() {
    line(true, -6.0, 20.0, 2.5);
    line(true, -6.0, 0.0, -3.0);
    drive(-5.0, 8.0);
    assertThat(runs(sides(), 0.6, 7.5, -3.0)).isTrue();

    line(true, 3.0, 12.0, -1.8);
    drive(8.0, 24.0); // farther than sides are still looked for
    assertThat(sides()).noneMatch(p -> p.x() > 3.3 && p.x() < 11.7 && p.y() < -1.9);
  }

  @Test
  void sides_bothLinesHaveAGap_areBridgedWhereTheyGoOn() {
    line(true, -6.0, 0.0, 2.0);
    line(true, -6.0, 0.0, -2.0);
    drive(-5.0, 5.0);
    assertThat(sides()).as("nothing says yet that the lane goes on").noneMatch(p -> p.x() > 1.6);
    line(true, 6.0, 12.0, 2.0);
    line(true, 6.0, 12.0, -2.0);
    drive(5.0, 9.0);
    List<Point> sides = sides();
    assertThat(runs(sides, 0.3, 5.7, 2.0)).isTrue();
    assertThat(runs(sides, 0.3, 5.7, -2.0)).isTrue();
  }

  @Test
  void sides_bothLinesEnd_theLaneEnds() {
    line(true, -6.0, 0.0, 2.0);
    line(true, -6.0, 0.0, -2.0);
    drive(-5.0, 12.0);
    assertThat(sides()).noneMatch(p -> p.x() > 1.6);
  }

  /** As in no-man's land: the way leads away from the only line, through where its lane was. */
  private void leaveThroughTheMissingSide() {
    line(true, -6.0, 20.0, 2.0);
    line(true, -6.0, 0.0, -2.0);
    drive(-5.0, 0.0);
    for (double x = 0.0; x <= 9.0; x += 0.1) {
      lane.at(Point.of(x, -0.45 * x, 0.0), 0L);
    }
  }

  @Test
  void sides_vehicleHasPassedTheMissingSide_theLaneEnds() {
    leaveThroughTheMissingSide();
    assertThat(sides()).isNotEmpty().allSatisfy(p -> assertThat(p.x()).isLessThan(5.5));
  }

  @Test
  void wayBack_vehicleHasPassedTheMissingSide_liesAcrossTheLane() {
    leaveThroughTheMissingSide();
    for (double x = 9.0; x <= 12.0; x += 0.1) {
      lane.at(Point.of(x, -0.45 * x, 0.0), 0L);
    }
    sides();
    assertThat(lane.wayBack())
        .hasSize(2)
        .anySatisfy(p -> assertThat(p.y() + 0.45 * p.x()).isPositive())
        .anySatisfy(p -> assertThat(p.y() + 0.45 * p.x()).isNegative());
  }

  @Test
  void sides_onlyOneLineEverSeen_isNoLane() {
    line(false, -6.0, 20.0, 2.0);
    drive(-5.0, 8.0);
    assertThat(sides()).isEmpty();
  }

  @Test
  void sides_linesFartherApartThanALane_areNone() {
    line(false, -6.0, 20.0, 2.0);
    line(false, -6.0, 20.0, -5.0);
    drive(-5.0, 8.0);
    assertThat(sides()).isEmpty();
  }

  @Test
  void sides_lineOfTheNextLaneSeenThroughAGap_isNotTaken() {
    line(true, -6.0, 20.0, 2.0);
    line(true, -6.0, 0.0, -2.0);
    line(true, 4.0, 20.0, -2.0);
    line(true, -6.0, 20.0, -3.9);
    drive(-5.0, 8.0);
    assertThat(runs(sides(), 0.3, 3.6, -2.0)).isTrue();
  }

  @Test
  void sides_afterBackingOut_areThoseOfBefore() {
    line(true, -6.0, 20.0, 2.0);
    line(true, -6.0, 0.0, -2.0);
    drive(-5.0, 5.0);
    List<Point> before = sides();
    for (double x = 4.9; x > 2.0; x -= 0.1) {
      lane.at(Point.of(x, 0.05, 0.0), 0L);
    }
    assertThat(sides()).isEqualTo(before);
  }

  @Test
  void sides_afterATightTurn_standNowhereOnTheWay() {
    line(true, -6.0, 2.0, 2.0);
    line(true, -6.0, -2.0, -2.0);
    drive(-5.0, 0.0);
    for (double y = 0.0; y >= -6.0; y -= 0.1) { // a corner to the right
      lane.at(Point.of(0.0, y, 0.0), 0L);
    }
    for (Point side : sides()) {
      double x = Math.max(-5.0, Math.min(0.0, side.x()));
      double y = Math.max(-6.0, Math.min(0.0, side.y()));
      double away =
          Math.min(Math.hypot(side.x() - x, side.y()), Math.hypot(side.x(), side.y() - y));
      assertThat(away).isGreaterThan(0.8);
    }
  }

  @Test
  void sides_atTheVehicle_areThoseThatLeadToIt() {
    line(true, -6.0, 20.0, 2.0);
    line(true, -6.0, 0.0, -2.0);
    line(true, 3.0, 6.0, -2.0);
    drive(-5.0, 8.0);
    assertThat(lane.sides(known, REACH))
        .hasSize(2)
        .anySatisfy(side -> assertThat(side.atVehicle()).isFalse())
        .filteredOn(DrivenLane.Inferred::atVehicle)
        .singleElement()
        .satisfies(side -> assertThat(side.points().get(0).x()).isGreaterThan(5.5));
  }

  private void wholeLane(double toX) {
    line(true, -6.0, toX, 2.0);
    line(true, -6.0, toX, -2.0);
  }

  @Test
  void wayBack_inALane_leadsAcrossItBehindTheVehicle() {
    wholeLane(20.0);
    drive(-5.0, 8.0);
    sides();
    assertThat(lane.wayBack())
        .hasSize(2)
        .allSatisfy(p -> assertThat(p.x()).isBetween(1.0, 2.0))
        .anySatisfy(p -> assertThat(p.y()).isEqualTo(2.0))
        .anySatisfy(p -> assertThat(p.y()).isEqualTo(-2.0));
  }

  @Test
  void wayBack_beyondTheLane_leadsAcrossItsEnd() {
    wholeLane(0.0);
    drive(-5.0, 15.0);
    sides();
    assertThat(lane.wayBack()).hasSize(2).allSatisfy(p -> assertThat(p.x()).isBetween(-0.5, 1.5));
  }

  @Test
  void wayBack_backedOutALittle_staysWhereItIs() {
    wholeLane(20.0);
    drive(-5.0, 8.0);
    sides();
    List<Point> before = lane.wayBack();
    lane.at(Point.of(4.0, 0.1, 0.0), 0L);
    assertThat(lane.wayBack()).isEqualTo(before);
  }

  @Test
  void wayBack_drivenBackBeyondIt_isOpen() {
    wholeLane(20.0);
    drive(-5.0, 8.0);
    sides();
    lane.at(Point.of(0.0, 0.1, 0.0), 0L);
    assertThat(lane.wayBack()).isEmpty();
  }

  @Test
  void wayBack_noLane_isOpen() {
    line(true, -6.0, 20.0, 2.0);
    drive(-5.0, 8.0);
    sides();
    assertThat(lane.wayBack()).isEmpty();
  }

  @Test
  void isHeldUp_noNewPlaceForHalfAMinute_is() {
    lane.at(Point.of(0.0, 0.0, 0.0), 0L);
    lane.at(Point.of(1.0, 0.0, 0.0), 10_000_000L);
    assertThat(lane.isHeldUp(30_000_000L)).isFalse();
    lane.at(Point.of(0.0, 0.1, 0.0), 30_000_000L); // back, which is no progress
    assertThat(lane.isHeldUp(40_000_000L)).isTrue();
  }

  @Test
  void sides_longStretchWithOneLine_stayKnownFarBehind() {
    line(true, -6.0, 30.0, 2.0);
    line(true, -6.0, 0.0, -2.0);
    line(true, 9.0, 30.0, -2.0);
    drive(-5.0, 13.0);
    assertThat(runs(sides(), 0.3, 8.7, -2.0)).isTrue();
    for (double x = 13.0; x < 28.0; x += 0.3) {
      lane.at(Point.of(x, 0.0, 0.0), 0L);
      sides();
    }
    assertThat(runs(sides(), 0.3, 8.7, -2.0)).isTrue();
  }

  @Test
  void clear_everything_isForgotten() {
    line(true, -6.0, 20.0, 2.0);
    line(true, -6.0, 0.0, -2.0);
    drive(-5.0, 8.0);
    lane.clear();
    assertThat(sides()).isEmpty();
  }
}
