package org.u2sa.planning.search;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** A vehicle 1.0 m long and 0.6 m wide, whose reference point is 0.2 m before its rear. */
class PassedGroundTest {
  private static final Inflation INFLATION = new Inflation(0.5, 1.0, 3.0);
  private static final BodyDiscs BODY = new BodyDiscs(0.8, 0.2, 0.6);
  private static final double EAST = Math.toRadians(90.0);

  private final CostGrid grid = unseen(new GridFrame(-3.0, -3.0, 0.1, 60, 60));

  private static CostGrid unseen(GridFrame frame) {
    CostGrid grid = new CostGrid(frame, INFLATION);
    grid.update(i -> false, i -> true);
    return grid;
  }

  @Test
  void add_vehicleFacingEast_coversItsOutlineAlone() {
    grid.passed().add(BODY, 0.0, 0.0, EAST);

    assertThat(grid.isUnseen(0.0, 0.75)).isFalse();
    assertThat(grid.isUnseen(0.25, -0.15)).isFalse();
    assertThat(grid.isUnseen(0.0, 0.95)).isTrue();
    assertThat(grid.isUnseen(0.0, -0.35)).isTrue();
    assertThat(grid.isUnseen(0.45, 0.0)).isTrue();
  }

  @Test
  void add_vehicleBesideTheGrid_isIgnored() {
    grid.passed().add(BODY, 50.0, 0.0, EAST);

    assertThat(grid.isUnseen(0.0, 0.0)).isTrue();
  }

  @Test
  void addAll_finerGridElsewhere_keepsWhatWasPassed() {
    grid.passed().add(BODY, 1.0, 1.0, EAST);
    CostGrid next = unseen(new GridFrame(0.0, 0.0, 0.05, 60, 60));
    next.passed().addAll(grid.passed());

    assertThat(next.isUnseen(1.0, 1.0)).isFalse();
    assertThat(next.isUnseen(2.0, 2.0)).isTrue();
  }

  @Test
  void isRearUnseen_whereTheVehicleWas_isFalseUntilItLeavesThat() {
    grid.passed().add(BODY, 0.0, 0.0, 0.0);
    grid.passed().add(BODY, 0.5, 0.0, 0.0);

    assertThat(BODY.isRearUnseen(grid, 0.2, 0.0, 0.0)).isFalse();
    assertThat(BODY.isRearUnseen(grid, -0.2, 0.0, 0.0)).isTrue();
  }

  @Test
  void isRearUnseen_cornerAlone_isTrue() {
    grid.update(i -> false, i -> grid.frame().centreEastM(i) > 0.2);

    assertThat(BODY.isRearUnseen(grid, 0.0, 0.0, 0.0)).isTrue();
    assertThat(BODY.isRearUnseen(grid, 0.0, -0.2, 0.0)).isFalse();
  }

  @Test
  void isRearUnseen_outsideTheGrid_isFalse() {
    assertThat(BODY.isRearUnseen(grid, 50.0, 0.0, 0.0)).isFalse();
  }
}
