package org.u2sa.world.coverage;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.frame.UtmGrid;
import org.u2sa.messages.goal.SearchArea;
import org.u2sa.messages.shape.CoverageLedger;
import org.u2sa.messages.shape.ImageFootprint;

class AreaCellsTest {
  private static List<Point> rectangle(double west, double south, double east, double north) {
    return List.of(
        Point.of(west, south, 0.0),
        Point.of(east, south, 0.0),
        Point.of(east, north, 0.0),
        Point.of(west, north, 0.0));
  }

  private static AreaCells area() {
    SearchArea goal =
        new SearchArea()
            .referenceFrame(ReferenceFrame.LOCAL_ENU)
            .corners(rectangle(0.0, 0.0, 100.0, 100.0))
            .resolution(0.05)
            .uid("1");
    return new AreaCells(goal, 5.0);
  }

  private static ImageFootprint image(double resolution, List<Point> corners) {
    ImageFootprint image = new ImageFootprint().image(300).resolution(resolution).points(corners);
    image.referenceFrame(ReferenceFrame.LOCAL_ENU).x(0.0).y(0.0);
    return image;
  }

  @Test
  void see_westernHalf_halfIsSeenWithinTheMargin() {
    AreaCells cells = area();
    cells.see(image(0.04, rectangle(-10.0, -10.0, 50.0, 110.0)), 0.0);
    assertThat(cells.ledger().share(0.05)).isCloseTo(0.5, within(1e-9));
    AreaCells careful = area();
    careful.see(image(0.04, rectangle(-10.0, -10.0, 50.0, 110.0)), 2.0);
    assertThat(careful.ledger().share(0.05)).isCloseTo(0.45, within(1e-9));
  }

  /** Along a road: cells grow until all of it has some. */
  @Test
  void ledger_longAndNarrowArea_cellsCoverAllOfIt() {
    SearchArea road =
        new SearchArea()
            .referenceFrame(ReferenceFrame.LOCAL_ENU)
            .corners(rectangle(0.0, 0.0, 200_000.0, 6.0))
            .resolution(0.05)
            .uid("1");
    CoverageLedger ledger = new AreaCells(road, 5.0).ledger();
    assertThat(ledger.columns() * ledger.cell()).isGreaterThanOrEqualTo(200_000.0);
    assertThat(ledger.rows() * ledger.cell()).isGreaterThanOrEqualTo(6.0);
  }

  @Test
  void see_tooCoarse_countsForACoarserResolutionOnly() {
    AreaCells cells = area();
    cells.see(image(0.08, rectangle(-10.0, -10.0, 110.0, 110.0)), 0.0);
    assertThat(cells.ledger().share(0.05)).isZero();
    assertThat(cells.ledger().share(0.08)).isEqualTo(1.0);
  }

  @Test
  void see_coarserAfterFiner_keepsTheBetterView() {
    AreaCells cells = area();
    cells.see(image(0.04, rectangle(-10.0, -10.0, 110.0, 110.0)), 0.0);
    cells.see(image(0.09, rectangle(-10.0, -10.0, 110.0, 110.0)), 0.0);
    assertThat(cells.ledger().share(0.05)).isEqualTo(1.0);
  }

  @Test
  void see_imageInOtherAxes_isSeenWhereItIs() {
    AreaCells cells = area();
    ImageFootprint image = image(0.04, rectangle(-10.0, -10.0, 110.0, 50.0)); // north, then east
    image.referenceFrame(ReferenceFrame.LOCAL_NED);
    cells.see(image, 0.0);
    assertThat(cells.ledger().share(0.05)).isCloseTo(0.5, within(1e-9));
    cells.see(image(0.04, rectangle(50.0, -10.0, 110.0, 110.0)), 0.0); // the eastern half
    assertThat(cells.ledger().share(0.05)).isEqualTo(1.0);
  }

  @Test
  void see_imageOfAnAreaOnAGrid_isSeen() {
    Geodetic corner = new Geodetic(9.0, 48.0, 0.0);
    ReferenceFrame grid = UtmGrid.frameAt(corner);
    Point at = new UtmGrid(grid).grid(corner);
    SearchArea goal =
        new SearchArea()
            .referenceFrame(grid)
            .corners(rectangle(at.x(), at.y(), at.x() + 100.0, at.y() + 100.0))
            .resolution(0.05)
            .uid("1");
    AreaCells cells = new AreaCells(goal, 5.0);
    ImageFootprint image = image(0.04, rectangle(8.999, 47.999, 9.002, 48.002));
    image.referenceFrame(ReferenceFrame.GLOBAL).x(9.0).y(48.0);
    cells.see(image, 0.0);
    assertThat(cells.ledger().share(0.05)).isEqualTo(1.0);
  }

  @Test
  void restore_ledgerOfBefore_keepsWhatWasSeen() {
    AreaCells before = area();
    before.see(image(0.04, rectangle(-10.0, -10.0, 50.0, 110.0)), 0.0);
    AreaCells after = area();
    after.restore(before.ledger());
    assertThat(after.ledger()).isEqualTo(before.ledger());
  }
}
