package org.u2sa.messages.schema;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.cbor.MalformedMessageException;
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

  /** Columns, rows and packed cells as any program may send them. */
  private void assertRefused(long columns, long rows, List<String> cells, String expected) {
    byte[] bytes = new ForeignGrid(columns, rows, cells).serialize();

    assertThatThrownBy(() -> codec.decode(OccupancyGrid.TYPE.chain(), bytes))
        .isInstanceOf(MalformedMessageException.class)
        .hasMessageContaining(expected);
  }

  @Test
  void decode_cellsThatDoNotFit_isRefusedBeforeMemoryIsTaken() {
    List<String> four = cells(grid().cells(2, new byte[4]));

    assertRefused(2, Long.MAX_VALUE, four, "rows: 9223372036854775807");
    assertRefused(-1, 2, four, "columns: -1");
    assertRefused(2, 3, four, "end after 4 of 6");
    assertRefused(2, 1, four, "more than 2 × 1");
    assertRefused(0, 0, four, "more than 0 × 0");
    assertRefused(2, 2, List.of("~~"), "OccupancyGrid.cells: are not zlib data in Base64");
    assertRefused(2, 2, List.of("AAAA"), "OccupancyGrid.cells: are not zlib data in Base64");
    assertRefused(2, 2, List.of(), "end after 0 of 4");
  }

  @Test
  void decode_noCellsAtAll_isTaken() throws MalformedMessageException {
    byte[] bytes = new ForeignGrid(0, 0, List.of()).serialize();

    OccupancyGrid read = (OccupancyGrid) codec.decode(OccupancyGrid.TYPE.chain(), bytes);

    assertThat(read.cells()).isEmpty();
  }

  @Test
  void freeze_fieldsSetByNameThatDoNotFit_isRefused() {
    OccupancyGrid grid = grid().cells(2, new byte[4]);
    OccupancyGrid.TYPE.field("rows").orElseThrow().set(grid, 3L);

    assertThatThrownBy(grid::freeze).hasMessage("OccupancyGrid.cells: 4; expected 2 × 3");
  }

  @Test
  void copy_ofAGrid_isEqualAndConsistent() {
    OccupancyGrid copy = grid().cells(2, new byte[] {1, 2, 3, 4}).copy();

    copy.freeze();

    assertThat(copy.cell(1, 1)).isEqualTo((byte) 4);
    assertThat(copy).isEqualTo(grid().cells(2, new byte[] {1, 2, 3, 4}));
  }

  @SuppressWarnings("unchecked")
  private static List<String> cells(OccupancyGrid grid) {
    return (List<String>) OccupancyGrid.TYPE.field("cells").orElseThrow().get(grid).orElseThrow();
  }

  /** A grid of a program that checks nothing. */
  private static final class ForeignGrid extends U2SAData {
    private static final Schema<ForeignGrid> SCHEMA =
        Schema.of("OccupancyGrid", ForeignGrid.class, ForeignGrid::new, U2SAData.TYPE);
    private static final NumberField<ForeignGrid> X = SCHEMA.requiredCoordinate("x");
    private static final NumberField<ForeignGrid> Y = SCHEMA.requiredCoordinate("y");
    private static final NumberField<ForeignGrid> RESOLUTION =
        SCHEMA.requiredNumber("resolution", "m", 0.0, 1e9);
    private static final ValueField<ForeignGrid, Long> COLUMNS = SCHEMA.count("columns", "");
    private static final ValueField<ForeignGrid, Long> ROWS = SCHEMA.count("rows", "");
    private static final ValueField<ForeignGrid, List<String>> CELLS = SCHEMA.texts("cells");
    private static final MessageType<ForeignGrid> OWN_TYPE = SCHEMA.build();

    private ForeignGrid() {}

    ForeignGrid(long columns, long rows, List<String> cells) {
      put(X, 0.0);
      put(Y, 0.0);
      put(RESOLUTION, 0.5);
      put(COLUMNS, columns);
      put(ROWS, rows);
      put(CELLS, cells);
    }

    @Override
    public MessageType<ForeignGrid> type() {
      return OWN_TYPE;
    }
  }
}
