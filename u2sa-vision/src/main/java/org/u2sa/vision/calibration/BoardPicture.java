package org.u2sa.vision.calibration;

import java.util.List;
import org.u2sa.vision.lens.LensCalibration.Spot;

/**
 * Detection result of one chessboard image.
 *
 * @param name image name, for messages
 * @param corners detected corners [px], row-major on the board; empty if no board was found
 * @param errorPx mean reprojection error of the corners [px]
 */
public record BoardPicture(String name, List<Spot> corners, double errorPx) {
  public boolean hasBoard() {
    return !corners.isEmpty();
  }
}
