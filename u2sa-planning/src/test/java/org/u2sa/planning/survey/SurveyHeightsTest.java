package org.u2sa.planning.survey;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.terrain.HeightGrid;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.SearchArea;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.seen.PlanningPlane;

/** Over a plain of 100 m with a step to 130 m in the north: 48 m above it by the camera. */
class SurveyHeightsTest {
  private static final SurveyVariables CAMERA =
      new SurveyVariables(1372.0, 1280.0, 0.3, 0.7, 40.0, 8, 0.1, "");
  private static final double HEIGHT_M = 0.7 * 0.05 * 1372.0;
  private static final int STEP_ROW = 20; // of 40, each 0.0001 degrees or 11 m
  private static final double STEP_M = 111.2; // north of the origin, to the middle of the slope

  @TempDir private Path folder;
  private final PlanningPlane plane =
      PlanningPlane.at(
          new StateInformation()
              .referenceFrame(ReferenceFrame.GLOBAL)
              .x(10.0)
              .y(50.0)
              .z(100.0)
              .psi(0.0));

  private static SearchArea area() {
    Point corner = Point.of(10.0, 50.0, 0.0);
    return new SearchArea()
        .corners(
            List.of(
                corner,
                corner.plus(Point.of(0.01, 0.0, 0.0)),
                corner.plus(Point.of(0.0, 0.01, 0.0))))
        .resolution(0.05)
        .ground(100.0)
        .uid("a");
  }

  private SurveyHeights heights() throws IOException {
    StringBuilder text =
        new StringBuilder(
            "ncols 40\nnrows 40\nxllcenter 9.998\nyllcenter 49.999\ncellsize 0.0001\n");
    for (int i = 0; i < 40 * 40; i++) {
      text.append(i / 40 < STEP_ROW ? "130 " : "100 ");
    }
    Path file = Files.writeString(folder.resolve("map.asc"), text.toString());
    return new SurveyHeights(Optional.of(HeightGrid.read(file)));
  }

  private double altitude(SurveyHeights heights, double northM) {
    return heights.altitudeM(area(), CAMERA, plane, new Pose(northM, 0.0, 0.0));
  }

  @Test
  void altitudeM_withoutMap_isLevel() {
    assertThat(altitude(new SurveyHeights(Optional.empty()), 150.0)).isEqualTo(100.0 + HEIGHT_M);
  }

  @Test
  void altitudeM_onTheHill_isAboveItsTop() throws IOException {
    assertThat(altitude(heights(), 200.0)).isEqualTo(130.0 + HEIGHT_M, Offset.offset(0.01));
  }

  @Test
  void altitudeM_beforeTheHill_climbsNoSteeperThanTheVehicle() throws IOException {
    SurveyHeights heights = heights();
    double before = altitude(heights, -300.0);
    for (double north = -295.0; north < 200.0; north += 5.0) {
      double now = altitude(heights, north);
      assertThat(Math.abs(now - before)).isLessThan(0.1 * 5.0 + 2.1); // samples 20 m apart
      before = now;
    }
    assertThat(altitude(heights, STEP_M)).isGreaterThan(125.0 + HEIGHT_M);
    assertThat(altitude(heights, STEP_M - 100.0)).isEqualTo(120.0 + HEIGHT_M, Offset.offset(3.0));
  }

  @Test
  void altitudeM_limitsOfTheArea_hold() throws IOException {
    SearchArea low = area().highest(160.0);
    assertThat(heights().altitudeM(low, CAMERA, plane, new Pose(200.0, 0.0, 0.0))).isEqualTo(160.0);
  }
}
