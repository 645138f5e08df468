package org.u2sa.vision.camera;

import java.util.Optional;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.vision.lens.LensCalibration;

/** Selects the lens geometry: calibrated, reported by the camera, or assumed. */
public final class LensChoice {
  private final Optional<LensCalibration> calibrated;
  private final double viewRad;
  private LensCalibration last;

  /**
   * @param calibrated by a chessboard
   * @param viewRad horizontal field of view to assume otherwise [rad]
   */
  public LensChoice(Optional<LensCalibration> calibrated, double viewRad) {
    this.calibrated = calibrated;
    this.viewRad = viewRad;
  }

  /**
   * Geometry for an image.
   *
   * @throws IllegalArgumentException if the calibration images had a different aspect ratio
   */
  public LensCalibration of(CameraFrame frame) {
    if (calibrated.isPresent()) {
      boolean isKnown =
          last != null && last.width() == frame.width() && last.height() == frame.height();
      last = isKnown ? last : calibrated.get().scaledTo(frame.width(), frame.height());
      return last;
    }
    return frame
        .intrinsics()
        .map(pinhole -> LensCalibration.pinhole(frame.width(), frame.height(), pinhole))
        .orElseGet(() -> LensCalibration.ofView(frame.width(), frame.height(), viewRad));
  }

  @Override
  public String toString() {
    return calibrated
        .map(
            lens ->
                String.format(
                    "calibrated with %d pictures, %.2f px", lens.pictures(), lens.errorPx()))
        .orElse("not calibrated");
  }
}
