package org.u2sa.report.mosaic;

import java.util.Collection;
import java.util.Locale;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.frame.UtmGrid;

/**
 * Pixels of a mosaic in a UTM zone, north up.
 *
 * @param frame UTM zone
 * @param westM easting of the left edge
 * @param northM northing of the upper edge
 * @param pixelM side of a pixel on the ground
 * @param columns number of columns
 * @param rows number of rows
 */
public record MosaicGrid(
    ReferenceFrame frame, double westM, double northM, double pixelM, int columns, int rows) {
  private static final double MIN_PIXEL_M = 0.005;
  private static final double MAX_PIXEL_M = 100.0;
  private static final long MAX_PIXELS = 40_000_000L; // 8 bytes of memory each
  static final double MAX_SPAN_M = 20_000.0; // UTM is distorted far from its zone

  /**
   * Creates a grid that covers positions.
   *
   * @param places positions, at least one
   * @param marginM margin on all sides
   * @throws BadInputException if the pixels are too small or too many
   */
  public static MosaicGrid around(Collection<Geodetic> places, double pixelM, double marginM) {
    if (!(pixelM >= MIN_PIXEL_M && pixelM <= MAX_PIXEL_M)) {
      throw new BadInputException(
          "resolution "
              + pixelM
              + ": expected "
              + MIN_PIXEL_M
              + "…"
              + MAX_PIXEL_M
              + " m per pixel");
    }
    ReferenceFrame frame = UtmGrid.frameAt(places.iterator().next());
    UtmGrid utm = new UtmGrid(frame);
    double west = Double.POSITIVE_INFINITY;
    double east = Double.NEGATIVE_INFINITY;
    double south = Double.POSITIVE_INFINITY;
    double north = Double.NEGATIVE_INFINITY;
    for (Geodetic place : places) {
      Point at = utm.grid(place);
      west = Math.min(west, at.x() - marginM);
      east = Math.max(east, at.x() + marginM);
      south = Math.min(south, at.y() - marginM);
      north = Math.max(north, at.y() + marginM);
    }
    double columns = Math.ceil((east - west) / pixelM);
    double rows = Math.ceil((north - south) / pixelM);
    if (!(east - west <= MAX_SPAN_M && north - south <= MAX_SPAN_M)
        || columns * rows > MAX_PIXELS) {
      throw new BadInputException(
          String.format(
              Locale.ROOT,
              "a mosaic of %.0f m by %.0f m with pixels of %s m: expected at most %d pixels and %.0f m; "
                  + "a coarser resolution may help",
              east - west,
              north - south,
              pixelM,
              MAX_PIXELS,
              MAX_SPAN_M));
    }
    return new MosaicGrid(
        frame, west, north, pixelM, Math.max(1, (int) columns), Math.max(1, (int) rows));
  }

  /** EPSG code of the coordinate reference system, WGS 84 / UTM. */
  int epsg() {
    return (frame.isNorth() ? 32_600 : 32_700) + frame.zone();
  }

  /** Easting of the middle of a column [m]. */
  double eastM(int column) {
    return westM + (column + 0.5) * pixelM;
  }

  /** Northing of the middle of a row [m]. */
  double northM(int row) {
    return northM - (row + 0.5) * pixelM;
  }
}
