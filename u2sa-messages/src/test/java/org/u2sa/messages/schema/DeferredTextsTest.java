package org.u2sa.messages.schema;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.cbor.Limits;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.registry.StandardTypes;

class DeferredTextsTest {
  private int made;

  private final DeferredTexts texts =
      new DeferredTexts(
          () -> {
            made++;
            return List.of("one", "two");
          });

  @Test
  void get_askedTwice_madeOnce() {
    assertThat(made).isZero();

    assertThat(texts.get(1)).isEqualTo("two");
    assertThat(texts).isEqualTo(List.of("one", "two"));
    assertThat(made).isEqualTo(1);
  }

  @Test
  void checked_notAskedYet_staysUnmade() {
    assertThat(ListKinds.TEXTS.checked(texts)).isSameAs(texts);
    assertThat(made).isZero();
  }

  @Test
  void get_textBeyondTheBounds_isRefused() {
    String longest = "x".repeat(Limits.TEXT_BYTES);
    assertThat(new DeferredTexts(() -> List.of(longest)).get(0)).isEqualTo(longest);
    DeferredTexts tooLong = new DeferredTexts(() -> List.of(longest + "x"));
    assertThatThrownBy(tooLong::size).isInstanceOf(IllegalArgumentException.class);
  }

  @Test
  void freeze_gridWithCells_theirTextsAreThoseOfTheCellsThen() throws MalformedMessageException {
    byte[] cells = {1, 2, 3, 4};
    OccupancyGrid grid =
        new OccupancyGrid()
            .anchor(ReferenceFrame.LOCAL_NED, Point.of(0.0, 0.0, 0.0))
            .resolution(0.5)
            .cells(2, cells);
    grid.freeze();
    cells[0] = 9; // the caller's own

    MessageCodec codec = new MessageCodec(StandardTypes.registry());
    OccupancyGrid read = (OccupancyGrid) codec.decode(OccupancyGrid.TYPE.chain(), grid.serialize());
    assertThat(read.cells()).containsExactly(1, 2, 3, 4);
    assertThat(grid.copy().cells()).containsExactly(1, 2, 3, 4);
  }
}
