package org.u2sa.messages.schema;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.registry.StandardTypes;

/** The grid's cells there and back, and what is refused. */
class OccupancyGridTest {
  private final MessageCodec codec = new MessageCodec(StandardTypes.registry());

  private static OccupancyGrid grid() {
    return new OccupancyGrid()
        .anchor(ReferenceFrame.LOCAL_NED, Point.of(100.0, 200.0, 0.0))
        .corner(-2.0, 1.0)
        .resolution(0.5);
  }

  private OccupancyGrid sent(OccupancyGrid grid) throws MalformedMessageException {
    return (OccupancyGrid) codec.decode(OccupancyGrid.TYPE.chain(), grid.serialize());
  }

  @Test
  void cells_afterTheWire_areThoseSet() throws MalformedMessageException {
    byte[] cells = new byte[700 * 900];
    new Random(3L).nextBytes(cells); // incompressible: more than one text
    OccupancyGrid read = sent(grid().cells(700, cells));

    assertThat(read.columns()).isEqualTo(700);
    assertThat(read.rows()).isEqualTo(900);
    assertThat(read.cells()).isEqualTo(cells);
    assertThat(read).isEqualTo(grid().cells(700, cells));
  }

  @Test
  void cells_aThousandSquareMostlyUnknown_takeFewBytes() {
    byte[] cells = new byte[1_000_000];
    Arrays.fill(cells, OccupancyGrid.UNKNOWN);
    Arrays.fill(cells, 300_000, 400_000, (byte) -40);

    assertThat(grid().cells(1_000, cells).serialize().length).isLessThan(8_000);
  }

  @Test
  void cellAt_aPointOfTheFrame_isTheCellAroundIt() {
    byte[] cells = {1, 2, 3, 4, 5, 6};
    OccupancyGrid grid = grid().cells(3, cells);

    assertThat(grid.cellAt(Point.of(98.1, 201.1, 0.0))).isEqualTo((byte) 1);
    assertThat(grid.cellAt(Point.of(99.4, 201.6, 0.0))).isEqualTo((byte) 6);
    assertThat(grid.cellAt(Point.of(97.9, 201.1, 0.0))).isEqualTo(OccupancyGrid.UNKNOWN);
    assertThat(grid.cellAt(Point.of(1e9, 201.1, 0.0))).isEqualTo(OccupancyGrid.UNKNOWN);
    assertThat(grid.cellAt(grid.centerOf(1, 1))).isEqualTo((byte) 5);
  }

  @Test
  void probability_ofLogOdds_isTheirLogistic() {
    assertThat(OccupancyGrid.probability(OccupancyGrid.UNKNOWN)).isEqualTo(0.5);
    assertThat(OccupancyGrid.probability((byte) 0)).isEqualTo(0.5);
    assertThat(OccupancyGrid.probability((byte) 20)).isCloseTo(Math.E / (1 + Math.E), within(1e-9));
  }

  @Test
  void cells_thatDoNotFit_areRefused() {
    assertThatThrownBy(() -> grid().cells(4, new byte[6])).hasMessageContaining("rows of 4");
    assertThatThrownBy(() -> grid().cells(5_000, new byte[5_000]))
        .hasMessageContaining("columns: 5000");
    assertThatThrownBy(() -> grid().resolution(0.0)).hasMessageContaining("resolution");
    assertThatThrownBy(() -> grid().corner(Double.NaN, 0.0)).hasMessageContaining("left");
  }

  @Test
  void cells_ofAHostileMessage_areRefusedBeforeMemoryIsTaken() throws MalformedMessageException {
    OccupancyGrid huge = grid().cells(2, new byte[4]);
    MessageField<OccupancyGrid> rows = OccupancyGrid.TYPE.field("rows").orElseThrow();
    rows.set(huge, Long.MAX_VALUE);
    OccupancyGrid read = sent(huge);
    assertThatThrownBy(read::cells).hasMessageContaining("rows: 9223372036854775807");

    OccupancyGrid more = grid().cells(2, new byte[4]);
    rows.set(more, 3L);
    OccupancyGrid short6 = sent(more);
    assertThatThrownBy(short6::cells).hasMessageContaining("end after 4 of 6");
    rows.set(more, 1L);
    OccupancyGrid long2 = sent(more);
    assertThatThrownBy(long2::cells).hasMessageContaining("more than 2 × 1");

    OccupancyGrid noBase64 = grid().cells(2, new byte[4]);
    OccupancyGrid.TYPE.field("cells").orElseThrow().set(noBase64, List.of("~~"));
    OccupancyGrid broken = sent(noBase64);
    assertThatThrownBy(broken::cells)
        .isInstanceOf(IllegalStateException.class)
        .hasMessageContaining("OccupancyGrid.cells");
  }
}
