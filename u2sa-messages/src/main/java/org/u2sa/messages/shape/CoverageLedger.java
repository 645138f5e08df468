package org.u2sa.messages.shape;

import java.util.List;
import org.u2sa.messages.cbor.ByteString;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.ValueField;

/**
 * Observed parts of a search area (thesis 4.4.1.3): for each cell the best resolution, and the
 * angle and the image of that view. Readers that do not know this class see the outline of the
 * area.
 *
 * <p>Cells are in rows from west to east, rows from south to north; cell (0, 0) has its south-west
 * corner at {@link #corner}. Cells outside the area have {@link #OUTSIDE} as angle.
 */
public final class CoverageLedger extends Polygon {
  /** Ground resolution per step of a cell's byte [m]; 0 means not seen. */
  public static final double RESOLUTION_STEP_M = 0.005;

  /** Angle of a cell outside the area. */
  public static final int OUTSIDE = 255;

  private static final Schema<CoverageLedger> SCHEMA =
      Schema.of(CoverageLedger.class, CoverageLedger::new, Polygon.TYPE).since(3);
  private static final ValueField<CoverageLedger, String> AREA = SCHEMA.requiredId("area");
  private static final ValueField<CoverageLedger, Point> CORNER =
      SCHEMA.requiredPoint("corner", "m");
  private static final NumberField<CoverageLedger> CELL =
      SCHEMA.requiredNumber("cell", "m", 0.1, 1_000.0);
  private static final ValueField<CoverageLedger, Long> COLUMNS = SCHEMA.count("columns", "");
  private static final ValueField<CoverageLedger, ByteString> RESOLUTIONS =
      SCHEMA.requiredBytes("resolutions");
  private static final ValueField<CoverageLedger, ByteString> ANGLES =
      SCHEMA.requiredBytes("angles");
  private static final ValueField<CoverageLedger, ByteString> IMAGES =
      SCHEMA.requiredBytes("images");

  public static final MessageType<CoverageLedger> TYPE = SCHEMA.build();

  @Override
  public MessageType<CoverageLedger> type() {
    return TYPE;
  }

  /** UID of the goal. */
  public String area() {
    return require(AREA);
  }

  public CoverageLedger area(String uid) {
    return put(AREA, uid);
  }

  /** South-west corner of the first cell, in the message's frame. */
  public Point corner() {
    return require(CORNER);
  }

  /** Side of a cell [m]. */
  public double cell() {
    return require(CELL);
  }

  /** Best ground resolution of each cell, in steps of {@link #RESOLUTION_STEP_M}; 0: not seen. */
  public ByteString resolutions() {
    return require(RESOLUTIONS);
  }

  /** Angle of that view from the vertical, for each cell [deg]; 255 outside the area. */
  public ByteString angles() {
    return require(ANGLES);
  }

  /** Number of that image modulo 65,536, two bytes per cell, big-endian. */
  public ByteString images() {
    return require(IMAGES);
  }

  /** Cells in a row. */
  public int columns() {
    return (int) (long) get(COLUMNS);
  }

  public int rows() {
    return columns() == 0 ? 0 : require(RESOLUTIONS).length() / columns();
  }

  /**
   * Sets the cells.
   *
   * @param resolutions in steps of {@link #RESOLUTION_STEP_M}
   * @param angles from the vertical [deg]
   * @param images numbers of the images, modulo 65,536, two bytes each, big-endian
   */
  public CoverageLedger cells(
      Point corner, double cellM, int columns, byte[] resolutions, byte[] angles, byte[] images) {
    put(CORNER, corner).put(CELL, cellM).put(COLUMNS, (long) columns);
    put(RESOLUTIONS, ByteString.copyOf(resolutions)).put(ANGLES, ByteString.copyOf(angles));
    return put(IMAGES, ByteString.copyOf(images));
  }

  @Override
  protected void requireConsistent() {
    super.requireConsistent();
    int cells = require(RESOLUTIONS).length();
    if (columns() < 1
        || cells % columns() != 0
        || require(ANGLES).length() != cells
        || require(IMAGES).length() != 2 * cells) {
      throw new IllegalStateException(
          String.format(
              "CoverageLedger: %d resolutions, %d angles, %d bytes of images in rows of %d; "
                  + "expected equal numbers, twice as many bytes, and full rows",
              cells, require(ANGLES).length(), require(IMAGES).length(), columns()));
    }
  }

  /** Copies the cells into arrays of the same lengths as those of {@link #cells}. */
  public void copyTo(byte[] resolutions, byte[] angles, byte[] images) {
    require(RESOLUTIONS).view().get(resolutions);
    require(ANGLES).view().get(angles);
    require(IMAGES).view().get(images);
  }

  /** Whether a cell is part of the area. */
  public boolean isInside(int cell) {
    return (require(ANGLES).view().get(cell) & 0xff) != OUTSIDE;
  }

  /** Whether a cell was seen at a resolution [m]. */
  public boolean isSeen(int cell, double resolutionM) {
    int steps = require(RESOLUTIONS).view().get(cell) & 0xff;
    return steps > 0 && steps * RESOLUTION_STEP_M <= resolutionM + 1e-9;
  }

  /** Fraction of the area's cells seen at a resolution [m], 0…1. */
  public double share(double resolutionM) {
    int inside = 0;
    int seen = 0;
    for (int i = 0; i < require(RESOLUTIONS).length(); i++) {
      if (isInside(i)) {
        inside++;
        seen += isSeen(i, resolutionM) ? 1 : 0;
      }
    }
    return inside == 0 ? 1.0 : (double) seen / inside;
  }

  @Override
  public CoverageLedger points(List<Point> value) {
    return (CoverageLedger) super.points(value);
  }
}
