package org.u2sa.vision.camera;

import java.util.List;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.vision.ground.CameraMount;
import org.u2sa.vision.ground.GroundSigma;
import org.u2sa.vision.ground.GroundView;
import org.u2sa.vision.ground.TopView;
import org.u2sa.vision.lens.LensCalibration;
import org.u2sa.vision.line.PaintFinder;
import org.u2sa.vision.line.PaintFinder.Paint;
import org.u2sa.vision.line.PaintFinder.PaintSettings;
import org.u2sa.vision.line.PaintFinder.PaintedDisc;
import org.u2sa.vision.line.PaintFinder.PaintedLine;
import org.u2sa.vision.object.ObjectFinder;
import org.u2sa.vision.object.ObjectSettings;
import org.u2sa.vision.object.SeenObject;
import org.u2sa.vision.picture.Shades;

/**
 * Detects lines, discs and objects on a course, image by image. Not thread-safe; reuses its
 * buffers, so results are valid until the next image.
 */
public final class CourseSight {
  private final CourseVariables settings;
  private final Shades shades = new Shades();
  private final TopView top;
  private final PaintFinder paint;
  private final ObjectFinder objects;
  private boolean[] hidden = new boolean[0];

  /**
   * Detections in one image.
   *
   * @param view projection between image and ground
   * @param lines nearest first
   * @param discs pothole markings
   * @param objects nearest first
   */
  public record Seen(
      GroundView view,
      List<PaintedLine> lines,
      List<PaintedDisc> discs,
      List<SeenObject> objects) {}

  public CourseSight(CourseVariables settings) {
    this.settings = settings;
    top =
        new TopView(
            new TopView.Area(
                settings.nearest(), settings.farthest(), settings.toEachSide(), settings.cellM()));
    paint =
        new PaintFinder(
            top.area(),
            new PaintSettings(
                settings.lineWidth(),
                settings.contrast(),
                settings.noiseFactor(),
                settings.minLineLength(),
                settings.maxGap(),
                settings.maxPieceLength()),
            settings.potholeRadius());
    objects =
        new ObjectFinder(
            new ObjectSettings(
                settings.barrelWidth(),
                settings.barrelHeight(),
                settings.barrelBase(),
                settings.sawhorseWidth(),
                settings.sawhorseClear(),
                settings.flagWidth(),
                settings.flagTop(),
                settings.flagCloth(),
                settings.maxObjectDistance()),
            new GroundSigma(
                0.0, settings.tiltSigma(), settings.yawSigma(), settings.ownSigma(), 0.0));
  }

  /**
   * Processes an image.
   *
   * @param frame decoded frame, not JPEG
   * @param lens geometry for this image size
   * @param rollRad roll of the vehicle at exposure, right side down positive
   * @param pitchRad pitch of the vehicle, front up positive
   */
  public Seen look(
      CameraFrame frame, LensCalibration lens, CameraMount mount, double rollRad, double pitchRad) {
    GroundView view = new GroundView(lens, mount, rollRad, pitchRad);
    shades.take(frame);
    int half = (frame.width() + 1) / 2 * ((frame.height() + 1) / 2);
    if (hidden.length < half) {
      hidden = new boolean[half];
    }
    List<SeenObject> found = objects.find(frame, view);
    objects.hide(hidden, frame.width(), frame.height());
    top.look(shades, view, hidden);
    Paint painted = paint.find(top, view);
    return new Seen(view, painted.lines(), painted.discs(), found);
  }

  /** Uncertainty of ground positions with this lens. */
  public GroundSigma sigma(LensCalibration lens) {
    return new GroundSigma(
        settings.pixelSigma() / lens.pinhole().focalX(),
        settings.tiltSigma(),
        settings.yawSigma(),
        settings.ownSigma(),
        0.0);
  }

  /** Bird's-eye view of the last image, for display. */
  public TopView top() {
    return top;
  }

  /** Paint strength of each of its cells, 0 for none; unsigned. */
  public byte[] strength() {
    return paint.strength();
  }
}
