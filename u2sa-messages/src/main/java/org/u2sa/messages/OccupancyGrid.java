package org.u2sa.messages;

import java.util.List;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.schema.DeferredTexts;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/**
 * Occupancy grid: which cells around the vehicle are occupied, free or unobserved (Moravec and
 * Elfes, "High resolution maps from wide angle sonar", ICRA 1985).
 *
 * <p>Cells lie along the x axis (columns) and the y axis (rows) of the frame, in GLOBAL along east
 * and north of the anchor. Cell (0, 0) has its corner {@link #left()} and {@link #bottom()} metres
 * from the anchor; a grid that rolls with the vehicle keeps the anchor and moves by whole cells.
 *
 * <p>A cell is a byte: {@link #UNKNOWN}, or the natural log odds of occupancy in steps of {@link
 * #LOG_ODDS_STEP}; positive means more likely occupied than free.
 */
public final class OccupancyGrid extends U2SAData {
  /** Value of an unobserved cell. */
  public static final byte UNKNOWN = Byte.MIN_VALUE;

  /** Log odds per step of a cell's byte. */
  public static final double LOG_ODDS_STEP = 0.05;

  private static final Schema<OccupancyGrid> SCHEMA =
      Schema.of(OccupancyGrid.class, OccupancyGrid::new, U2SAData.TYPE).since(3);
  private static final ValueField<OccupancyGrid, ReferenceFrame> REFERENCE_FRAME =
      SCHEMA.frame("referenceFrame", ReferenceFrame.GLOBAL);
  private static final NumberField<OccupancyGrid> X = SCHEMA.requiredCoordinate("x");
  private static final NumberField<OccupancyGrid> Y = SCHEMA.requiredCoordinate("y");
  private static final NumberField<OccupancyGrid> Z = SCHEMA.number("z", "m", 0.0);
  private static final NumberField<OccupancyGrid> LEFT = SCHEMA.number("left", "m", 0.0);
  private static final NumberField<OccupancyGrid> BOTTOM = SCHEMA.number("bottom", "m", 0.0);
  private static final NumberField<OccupancyGrid> RESOLUTION =
      SCHEMA.requiredNumber("resolution", "m", 0.01, 1_000.0);
  private static final ValueField<OccupancyGrid, Long> COLUMNS = SCHEMA.count("columns", "");
  private static final ValueField<OccupancyGrid, Long> ROWS = SCHEMA.count("rows", "");
  private static final ValueField<OccupancyGrid, List<String>> CELLS = SCHEMA.texts("cells");

  public static final MessageType<OccupancyGrid> TYPE = SCHEMA.build();

  private volatile byte[] unpacked; // unpacked CELLS; null until first needed

  @Override
  public MessageType<OccupancyGrid> type() {
    return TYPE;
  }

  /** Axes of the anchor and the cells; defaults to GLOBAL. */
  public ReferenceFrame referenceFrame() {
    return get(REFERENCE_FRAME);
  }

  /** Reference position of the cells; longitude, latitude [deg], altitude in GLOBAL. */
  public Point anchor() {
    return Point.of(require(X), require(Y), require(Z));
  }

  /** Sets {@link #referenceFrame()} and {@link #anchor()}. */
  public OccupancyGrid anchor(ReferenceFrame frame, Point anchor) {
    put(REFERENCE_FRAME, frame);
    put(X, anchor.x());
    put(Y, anchor.y());
    return put(Z, anchor.z());
  }

  /** From the anchor to the edge of column 0, along x [m]. */
  public double left() {
    return require(LEFT);
  }

  /** From the anchor to the edge of row 0, along y [m]. */
  public double bottom() {
    return require(BOTTOM);
  }

  /** Sets {@link #left()} and {@link #bottom()}. */
  public OccupancyGrid corner(double left, double bottom) {
    put(LEFT, left);
    return put(BOTTOM, bottom);
  }

  /** Cell size [m]. */
  public double resolution() {
    return require(RESOLUTION);
  }

  public OccupancyGrid resolution(double metres) {
    return put(RESOLUTION, metres);
  }

  /** Number of cells along x. */
  public int columns() {
    return GridCells.side("columns", require(COLUMNS));
  }

  /** Number of cells along y. */
  public int rows() {
    return GridCells.side("rows", require(ROWS));
  }

  /**
   * All cells in row-major order from the bottom: cell (column, row) is at {@code row * columns +
   * column}.
   */
  public byte[] cells() {
    return unpacked().clone();
  }

  /**
   * Sets columns, rows and cells.
   *
   * @throws IllegalArgumentException if they do not fit, or are too many
   */
  public OccupancyGrid cells(int columns, byte[] cells) {
    if (columns < 1 || cells.length % columns != 0) {
      throw new IllegalArgumentException(
          "OccupancyGrid.cells: " + cells.length + " are no rows of " + columns);
    }
    GridCells.side("columns", columns);
    GridCells.side("rows", cells.length / columns);
    put(COLUMNS, (long) columns);
    put(ROWS, (long) (cells.length / columns));
    byte[] own = cells.clone();
    put(CELLS, new DeferredTexts(() -> GridCells.pack(own)));
    unpacked = own;
    return this;
  }

  /** One cell; {@link #UNKNOWN} beyond the edges. */
  public byte cell(int column, int row) {
    boolean within = column >= 0 && row >= 0 && column < columns() && row < rows();
    return within ? unpacked()[row * columns() + column] : UNKNOWN;
  }

  /** The cell at a point of the frame; {@link #UNKNOWN} beyond the edges. */
  public byte cellAt(Point point) {
    Point metres = Metric.around(referenceFrame(), anchor()).metres(point);
    double column = Math.floor((metres.x() - left()) / resolution());
    double row = Math.floor((metres.y() - bottom()) / resolution());
    return Math.abs(column) < GridCells.MAX_SIDE && Math.abs(row) < GridCells.MAX_SIDE
        ? cell((int) column, (int) row)
        : UNKNOWN;
  }

  /** Centre of a cell, in the frame. */
  public Point centerOf(int column, int row) {
    Point metres =
        Point.of(
            left() + (column + 0.5) * resolution(), bottom() + (row + 0.5) * resolution(), 0.0);
    return Metric.around(referenceFrame(), anchor()).point(metres);
  }

  /** Occupancy probability of a cell [0…1]; ½ if unknown. */
  public static double probability(byte cell) {
    return cell == UNKNOWN ? 0.5 : 1.0 / (1.0 + Math.exp(-LOG_ODDS_STEP * cell));
  }

  /** Checks that columns, rows and packed cells agree. */
  @Override
  protected void requireConsistent() {
    long cells = (long) columns() * rows();
    if (unpacked().length != cells) { // fields may be set individually by name
      throw new IllegalStateException(
          "OccupancyGrid.cells: " + unpacked().length + "; expected " + columns() + " × " + rows());
    }
  }

  private byte[] unpacked() {
    byte[] cells = unpacked;
    if (cells == null) {
      cells = GridCells.unpack(require(CELLS), columns(), rows());
      unpacked = cells;
    }
    return cells;
  }

  @Override
  public OccupancyGrid copy() {
    OccupancyGrid copy = (OccupancyGrid) super.copy();
    copy.unpacked = unpacked;
    return copy;
  }
}
