package org.u2sa.planning.search;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** A vehicle 0.6 m long and 0.92 m wide, whose reference point is 0.2 m before its rear. */
class BodyDiscsTest {
  private static final double CELL = 0.05;
  private static final BodyDiscs CLOSE = BodyDiscs.closely(0.4, 0.2, 0.92, 0.075);
  private static final BodyDiscs ALONG = new BodyDiscs(0.4, 0.2, 0.92);

  private final CostGrid grid =
      new CostGrid(new GridFrame(-3.0, -3.0, CELL, 120, 120), new Inflation(0.5, 1.0, 3.0));

  /** Fills what lies farther east than this, to both sides. */
  private void passage(double halfM) {
    grid.update(i -> Math.abs(grid.frame().centreEastM(i)) > halfM, i -> false);
  }

  private double northward(BodyDiscs body) {
    return body.clearanceM(grid, 0.0, 0.0, 0.0);
  }

  @Test
  void clearanceM_passageWiderThanTheVehicleOnly_isFreeByTheCloseCoverAlone() {
    passage(0.55);
    assertThat(northward(CLOSE)).isBetween(0.02, 0.09);
    assertThat(northward(ALONG)).isNegative();
  }

  @Test
  void clearanceM_askewInTheSamePassage_touches() {
    passage(0.55);
    assertThat(CLOSE.clearanceM(grid, 0.0, 0.0, Math.toRadians(30.0))).isNegative();
  }

  @Test
  void clearanceM_passageNarrowerThanTheVehicle_touches() {
    passage(0.45);
    assertThat(northward(CLOSE)).isNegative();
  }

  @Test
  void clearanceM_wallBeforeTheFront_isSeenToAFewCentimetres() {
    grid.update(i -> grid.frame().centreNorthM(i) > 0.5, i -> false);
    assertThat(northward(CLOSE)).isBetween(0.02, 0.09);
    assertThat(northward(ALONG)).isNegative();
  }

  @Test
  void clearanceM_poleUnderTheMiddle_touches() {
    grid.update(i -> i == grid.frame().indexAt(0.1, 0.2), i -> false);
    assertThat(northward(CLOSE)).isNegative();
  }

  @Test
  void clearanceM_nothingNear_isPositiveWhateverTheHeading() {
    grid.update(i -> grid.frame().centreNorthM(i) > 2.0, i -> false);
    assertThat(CLOSE.clearanceM(grid, 0.0, 0.0, 1.0)).isPositive();
  }
}
