package org.u2sa.scenarios.suas.score;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Point;

class SuasScoreTest {
  private static ReportedTrack.Sample at(double time, double east) {
    return new ReportedTrack.Sample(time, east, 0.0, 0.0);
  }

  @Test
  void interpolated_gapOfSixSeconds_isNotBridged() {
    ReportedTrack telemetry = new ReportedTrack();
    telemetry.add(at(0.0, 0.0));
    telemetry.add(at(1.0, 10.0));
    telemetry.add(at(1.5, 10.0)); // a duplicate
    telemetry.add(at(7.0, 70.0));
    assertThat(telemetry.interpolated()).hasSize(12);
    assertThat(telemetry.interpolated().get(3).eastM()).isCloseTo(3.0, within(1e-9));
    assertThat(telemetry.meanGapS()).isEqualTo(3.5);
  }

  @Test
  void drop_distance_fallsToZeroAt150Feet() {
    assertThat(ScoreSheet.drop(0.0)).isEqualTo(1.0);
    assertThat(ScoreSheet.drop(15.24)).isCloseTo(2.0 / 3.0, within(1e-9)); // 50 ft
    assertThat(ScoreSheet.drop(60.0)).isZero();
    assertThat(ScoreSheet.drop(Double.POSITIVE_INFINITY)).isZero();
  }

  @Test
  void scores_waypointsPassedInTheWrongOrder_onlyOneCounts() {
    List<ReportedTrack.Sample> track = List.of(at(0.0, 0.0), at(1.0, 100.0));
    List<Point> wrong = List.of(Point.of(100.0, 0.0, 0.0), Point.ORIGIN);
    assertThat(WaypointScore.scores(wrong, track).stream().mapToDouble(each -> each).sum())
        .isEqualTo(1.0);
  }

  @Test
  void scores_randomTracks_areTheBestOfAllSequences() {
    Random random = new Random(5);
    for (int run = 0; run < 200; run++) {
      List<ReportedTrack.Sample> track = new ArrayList<>();
      for (int i = 0; i < 8; i++) {
        track.add(at(i, 60.0 * random.nextDouble()));
      }
      List<Point> waypoints = new ArrayList<>();
      for (int i = 0; i < 3; i++) {
        waypoints.add(Point.of(60.0 * random.nextDouble(), 0.0, 0.0));
      }
      double sum = WaypointScore.scores(waypoints, track).stream().mapToDouble(each -> each).sum();
      assertThat(sum).isCloseTo(best(waypoints, 0, track, 0), within(1e-9));
    }
  }

  /** Tries all ordered sequences. */
  private static double best(
      List<Point> waypoints, int waypoint, List<ReportedTrack.Sample> track, int from) {
    double best = 0.0;
    for (int j = from; waypoint < waypoints.size() && j < track.size(); j++) {
      double away = Math.abs(track.get(j).eastM() - waypoints.get(waypoint).x());
      double here = Math.max(0.0, 1.0 - away / 30.48);
      best = Math.max(best, here + best(waypoints, waypoint + 1, track, j));
    }
    return best;
  }

  @Test
  void see_backWithinTenSecondsAndOutAgain_countsOnce() {
    BoundaryCount count = new BoundaryCount();
    count.see(0.0, false);
    count.see(4.0, true);
    count.see(9.0, false);
    assertThat(count.count()).isEqualTo(1);
    count.see(19.5, false);
    assertThat(count.count()).isEqualTo(2);
  }

  @Test
  void of_halfTheFieldsAndThePlaceRight_scoresByTheRules() {
    ObjectScore.Sheet target =
        new ObjectScore.Sheet(0.0, 0.0, List.of("star", "red", "A", "blue", "N"));
    ObjectScore.Sheet report =
        new ObjectScore.Sheet(15.24, 0.0, List.of("star", "red", "B", "blue", "S"));
    ObjectScore.Sheet wrong = new ObjectScore.Sheet(500.0, 0.0, target.fields());
    ObjectScore.Result result = ObjectScore.of(List.of(target), List.of(report, wrong));
    assertThat(result.falseReports()).isEqualTo(1);
    assertThat(result.matches().get(0).rightFields()).isEqualTo(3);
    // 0.2 · 3/5 + 0.3 · (150 − 50) / 150 + 0.3 + 0.2, less 0.05 for the wrong report
    assertThat(result.score()).isCloseTo(0.77, within(1e-9));
  }

  @Test
  void total_partsByHand_isTheirWeightedSum() {
    ScoreSheet sheet = new ScoreSheet(1.0, 0.9, 0.5, 1, 1, false, 9, 10, 0.5, 1.0, 0.0, 1.0);
    // 0.1 + 0.2 · 0.7 + 0.1 · 0.729 + 0.2 · 0.5 + 0.1 + 0 + 0.1
    assertThat(sheet.total()).isCloseTo(0.6129, within(1e-9));
    assertThat(new ScoreSheet(1, 1, 1.5, 0, 0, false, 0, 0, 0, 0, 0, 0).flight()).isZero();
  }
}
