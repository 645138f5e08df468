package org.u2sa.vision.calibration;

import java.util.Locale;
import org.u2sa.interfaces.BadInputException;

/**
 * A printed chessboard as calibration target.
 *
 * @param columns inner corners, where four squares meet, along the longer side
 * @param rows inner corners along the shorter side
 * @param squareM edge of a square [m]
 */
public record Chessboard(int columns, int rows, double squareM) {
  private static final int LEAST = 3;

  /**
   * @throws BadInputException if it has too few corners or no square size
   */
  public Chessboard {
    if (columns < LEAST || rows < LEAST) {
      throw new BadInputException(
          "a chessboard of " + columns + "x" + rows + " corners: expected at least 3x3");
    }
    if (!(squareM > 0.0 && squareM < 10.0)) {
      throw new BadInputException(
          "squares of " + squareM + " m: expected an edge above 0 and below 10 m");
    }
  }

  /**
   * Parses a text such as 9x6.
   *
   * @throws BadInputException naming the text
   */
  public static Chessboard parse(String corners, double squareM) {
    String[] parts = corners.trim().toLowerCase(Locale.ROOT).split("x");
    try {
      if (parts.length == 2) {
        return new Chessboard(
            Integer.parseInt(parts[0].trim()), Integer.parseInt(parts[1].trim()), squareM);
      }
    } catch (NumberFormatException e) {
      throw new BadInputException(wrong(corners), e);
    }
    throw new BadInputException(wrong(corners));
  }

  private static String wrong(String corners) {
    return "board \"" + corners + "\": expected inner corners, columns x rows, such as 9x6";
  }

  @Override
  public String toString() {
    return columns + "x" + rows + " corners";
  }
}
