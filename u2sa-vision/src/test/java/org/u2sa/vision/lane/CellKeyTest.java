package org.u2sa.vision.lane;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import java.util.Set;
import org.junit.jupiter.api.Test;

class CellKeyTest {
  @Test
  void of_cellsOnBothSidesOfTheOrigin_keepsColumnAndRow() {
    for (int column : new int[] {-2_000_000, -1, 0, 1, 77}) {
      for (int row : new int[] {-3_000_000, -1, 0, 1, 99}) {
        long key = CellKey.of(column, row);
        assertThat(CellKey.column(key)).isEqualTo(column);
        assertThat(CellKey.row(key)).isEqualTo(row);
      }
    }
  }

  @Test
  void of_cellsOfASquare_haveDifferentHashCodes() {
    Set<Integer> hashes = new HashSet<>();
    for (int column = -100; column < 100; column++) {
      for (int row = -100; row < 100; row++) {
        hashes.add(Long.hashCode(CellKey.of(column, row)));
      }
    }
    assertThat(hashes).hasSizeGreaterThan(39_900);
  }
}
