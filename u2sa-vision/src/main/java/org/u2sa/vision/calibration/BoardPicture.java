package org.u2sa.vision.calibration;

import java.util.List;
import org.u2sa.vision.lens.LensCalibration.Spot;

/**
 * What was found in one picture of a chessboard.
 *
 * @param name of the picture, for messages
 * @param corners where they were found [pixels], row by row of the board; empty if no board was
 * @param errorPx mean distance of the corners from where the calibration puts them [pixels]
 */
public record BoardPicture(String name, List<Spot> corners, double errorPx) {
  /** Whether a whole board was found. */
  public boolean hasBoard() {
    return !corners.isEmpty();
  }
}
