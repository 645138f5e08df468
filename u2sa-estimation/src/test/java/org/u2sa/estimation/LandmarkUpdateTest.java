package org.u2sa.estimation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.LandmarkSighting;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.frame.UtmGrid;
import org.u2sa.testkit.ServiceKit;

/** Landmarks that the World Modeler recognised correct the state; other estimators ignore them. */
class LandmarkUpdateTest {
  private final ServiceKit kit = new ServiceKit();

  @AfterEach
  void end() {
    kit.close();
  }

  private void start() {
    StateInformation start =
        new StateInformation()
            .sensorName("start")
            .referenceFrame(ReferenceFrame.LOCAL_NED)
            .x(0.0)
            .y(0.0)
            .psi(0.0)
            .xSigma(1.0)
            .ySigma(1.0);
    kit.publish(Channels.SENSED_STATE, start.psiSigma(0.05));
  }

  /** A landmark at (north, east), seen from (0.5, 0.5) with the nose to the north. */
  private void sighting(double north, double east) {
    LandmarkSighting seen =
        new LandmarkSighting()
            .landmarkX(north)
            .landmarkY(east)
            .range(Math.hypot(north - 0.5, east - 0.5))
            .rangeSigma(0.1)
            .bearing(Math.atan2(east - 0.5, north - 0.5))
            .bearingSigma(0.03);
    seen.referenceFrame(ReferenceFrame.LOCAL_NED).sensorName("Landmarks camera");
    kit.publish(Channels.SENSED_STATE, seen);
  }

  private StateInformation newest() {
    return kit.latest(Channels.STATE).orElseThrow();
  }

  @Test
  void estimate_twoLandmarksSeen_fusingEstimatorMovesToWhereTheyAreSeenFrom() {
    kit.start(FusingStateEstimator::new);
    start();
    for (int i = 0; i < 20; i++) {
      kit.advance(0.5);
      sighting(4.0, 0.0);
      sighting(0.0, 5.0);
    }

    assertThat(newest().x().orElseThrow()).isCloseTo(0.5, within(0.15));
    assertThat(newest().y().orElseThrow()).isCloseTo(0.5, within(0.15));
    assertThat(newest().xSigma().orElseThrow()).isLessThan(0.3);
  }

  @Test
  void estimate_landmarkFarFromWhereItShouldBe_isGated() {
    kit.start(FusingStateEstimator::new);
    start();
    for (int i = 0; i < 20; i++) {
      kit.advance(0.5);
      sighting(4.0, 0.0);
      sighting(0.0, 5.0);
    }
    kit.advance(0.5);
    sighting(40.0, 30.0);
    LandmarkSighting wrong =
        new LandmarkSighting().landmarkX(4.0).landmarkY(0.0).range(9.0).rangeSigma(0.1);
    wrong.bearing(2.0).bearingSigma(0.03).referenceFrame(ReferenceFrame.LOCAL_NED);
    wrong.sensorName("Landmarks camera");
    kit.publish(Channels.SENSED_STATE, wrong);

    assertThat(newest().x().orElseThrow()).isCloseTo(0.5, within(0.2));
  }

  @Test
  void estimate_landmark_isNoStateForAnEstimatorThatPassesOn() {
    kit.start(PassThroughStateEstimator::new);
    start();
    int states = kit.published(Channels.STATE).size();
    sighting(4.0, 0.0);

    assertThat(kit.published(Channels.STATE)).hasSize(states);
  }

  @Test
  void estimate_landmarksOnAGrid_fusingEstimatorMovesToWhereTheyAreSeenFrom() {
    kit.start(FusingStateEstimator::new);
    Geodetic here = new Geodetic(9.0, 48.0, 0.0); // where grid north is true north
    ReferenceFrame grid = UtmGrid.frameAt(here);
    Point at = new UtmGrid(grid).grid(here);
    kit.publish(
        Channels.SENSED_STATE,
        new StateInformation()
            .sensorName("start")
            .referenceFrame(grid)
            .x(at.x() - 0.5)
            .y(at.y() - 0.5)
            .z(0.0)
            .psi(0.0)
            .xSigma(1.0)
            .ySigma(1.0)
            .psiSigma(0.05));
    for (int i = 0; i < 20; i++) {
      kit.advance(0.5);
      for (Point away : List.of(Point.of(4.0, 0.0, 0.0), Point.of(0.0, 5.0, 0.0))) {
        LandmarkSighting seen =
            new LandmarkSighting()
                .landmarkX(at.x() + away.x())
                .landmarkY(at.y() + away.y())
                .range(Math.hypot(away.x(), away.y()))
                .rangeSigma(0.1)
                .bearing(Math.atan2(away.x(), away.y()))
                .bearingSigma(0.03);
        seen.referenceFrame(grid).sensorName("Landmarks camera");
        kit.publish(Channels.SENSED_STATE, seen);
      }
    }

    Geodetic end = new Geodetic(newest().x().orElseThrow(), newest().y().orElseThrow(), 0.0);
    assertThat(end.distanceM(here)).isLessThan(0.2);
  }
}
