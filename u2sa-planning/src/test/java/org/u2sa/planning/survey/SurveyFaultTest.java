package org.u2sa.planning.survey;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.SearchArea;
import org.u2sa.messages.shape.CoverageLedger;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.seen.PlanningPlane;

/** Areas that the camera cannot see as it should, or that are too large for one plan. */
class SurveyFaultTest {
  private static final SurveyVariables CAMERA =
      new SurveyVariables(1372.0, 1280.0, 0.3, 0.7, 40.0, 8, 0.1, "");
  private static final List<Point> CORNERS =
      List.of(Point.of(0.0, 0.0, 0.0), Point.of(1000.0, 0.0, 0.0), Point.of(1000.0, 1000.0, 0.0));

  private static SearchArea area(double resolution) {
    return new SearchArea()
        .referenceFrame(ReferenceFrame.LOCAL_ENU)
        .corners(CORNERS)
        .resolution(resolution)
        .ground(40.0)
        .uid("a");
  }

  private static CoverageLedger ledger(double cellM, int columns, int rows) {
    int cells = columns * rows;
    CoverageLedger ledger = new CoverageLedger().points(CORNERS).area("a");
    ledger.referenceFrame(ReferenceFrame.LOCAL_ENU);
    return ledger.cells(
        Point.ORIGIN, cellM, columns, new byte[cells], new byte[cells], new byte[2 * cells]);
  }

  @Test
  void fault_usualArea_none() {
    assertThat(LaneLegs.fault(area(0.05), ledger(5.0, 10, 10), CAMERA)).isEmpty();
  }

  @Test
  void fault_lowestTooHigh_saysWhatAPixelCovers() {
    SearchArea area = area(0.05).lowest(200.0);
    assertThat(LaneLegs.fault(area, ledger(5.0, 10, 10), CAMERA))
        .hasValue("from 160 m above the ground a pixel covers 0.117 m; expected up to 0.050 m");
  }

  @Test
  void fault_cellsLargerThanAnImage_saysSo() {
    assertThat(LaneLegs.fault(area(0.005), ledger(50.0, 10, 10), CAMERA))
        .hasValueSatisfying(
            each -> assertThat(each).startsWith("cells of 50.0 m do not fit into an image of 4.5"));
  }

  @Test
  void over_scatteredCells_lanesOfAPassAreBounded() {
    int side = 140;
    CoverageLedger ledger = ledger(400.0, side, side); // each strip falls into many lanes
    byte[] seen = new byte[side * side];
    for (int i = 0; i < seen.length; i++) {
      seen[i] = (byte) (i % 2);
    }
    ledger.cells(Point.ORIGIN, 400.0, side, seen, new byte[seen.length], new byte[2 * seen.length]);
    StateInformation state = new StateInformation().sensorName("test");
    state.referenceFrame(ReferenceFrame.LOCAL_ENU).x(0.0).y(0.0).z(100.0).psi(0.0);
    List<LaneLegs.Leg> legs =
        LaneLegs.over(
            area(0.5),
            ledger,
            PlanningPlane.at(state),
            new Pose(0.0, 0.0, 0.0),
            new LaneLegs.Wind(22.0, 100.0, 0.0, 0.0),
            CAMERA);
    assertThat(legs).hasSizeBetween(1, 120);
  }
}
