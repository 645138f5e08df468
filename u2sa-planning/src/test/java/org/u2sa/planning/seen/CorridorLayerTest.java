package org.u2sa.planning.seen;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.planning.search.GridFrame;

class CorridorLayerTest {
  private static final GridFrame FRAME = new GridFrame(-10.0, -10.0, 0.5, 40, 40);

  private static PlanarShape square(String name, double halfM) {
    return new PlanarShape(
        name,
        PlanarShape.Kind.AREA,
        new double[] {-halfM, halfM, halfM, -halfM},
        new double[] {-halfM, -halfM, halfM, halfM},
        0.0,
        Double.NEGATIVE_INFINITY,
        Double.POSITIVE_INFINITY);
  }

  @Test
  void of_square_cellsBesideItAreOutside() {
    CorridorLayer layer = CorridorLayer.of(List.of(square("a", 4.0)), FRAME, null);

    for (int cell = 0; cell < FRAME.cells(); cell++) {
      boolean inside =
          Math.abs(FRAME.centreNorthM(cell)) < 4.0 && Math.abs(FRAME.centreEastM(cell)) < 4.0;
      assertThat(layer.isOutside(cell)).isEqualTo(!inside);
    }
  }

  @Test
  void of_sameOutline_isNotDrawnAgain() {
    CorridorLayer layer = CorridorLayer.of(List.of(square("a", 4.0)), FRAME, null);

    assertThat(CorridorLayer.of(List.of(square("b", 4.0)), FRAME, layer)).isSameAs(layer);
  }

  @Test
  void of_otherOutlineNumberOrWindow_isDrawnAgain() {
    List<PlanarShape> one = List.of(square("a", 4.0));
    CorridorLayer layer = CorridorLayer.of(one, FRAME, null);
    GridFrame moved = new GridFrame(-10.0, 0.0, 0.5, 40, 40);

    assertThat(CorridorLayer.of(List.of(square("a", 4.5)), FRAME, layer)).isNotSameAs(layer);
    assertThat(CorridorLayer.of(one, moved, layer)).isNotSameAs(layer);
    assertThat(CorridorLayer.of(List.of(square("a", 4.0), square("b", 1.0)), FRAME, layer))
        .isNotSameAs(layer);
  }
}
