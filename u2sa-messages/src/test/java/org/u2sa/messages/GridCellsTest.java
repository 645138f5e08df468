package org.u2sa.messages;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;

/** How large a received grid may be in a process with little memory. */
class GridCellsTest {
  private static final long MB = 1L << 20;

  @Test
  void maxReceived_smallHeap_isAPartOfItAndNeverMoreThanAGridMayHave() {
    assertThat(GridCells.maxReceived(48 * MB)).isEqualTo(786_432);
    assertThat(GridCells.maxReceived(4_096 * MB)).isEqualTo(4_096 * 4_096);
  }

  @Test
  void unpack_moreCellsThanTheHeapSufficesFor_isRefusedBeforeMemoryIsTaken() {
    List<String> packed = GridCells.pack(new byte[1_000]);

    assertThat(GridCells.unpack(packed, 100, 10, 1_000)).hasSize(1_000);
    assertThatThrownBy(() -> GridCells.unpack(packed, 100, 10, 999))
        .hasMessage("OccupancyGrid.cells: 100 × 10 are more than the 999 that fit into the heap");
  }
}
