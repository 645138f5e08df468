package org.u2sa.vision.camera;

import java.util.List;
import org.u2sa.device.CameraFrame;
import org.u2sa.vision.ground.CameraMount;
import org.u2sa.vision.ground.GroundSigma;
import org.u2sa.vision.ground.GroundView;
import org.u2sa.vision.ground.TopView;
import org.u2sa.vision.lens.LensCalibration;
import org.u2sa.vision.line.PaintFinder;
import org.u2sa.vision.line.PaintFinder.Paint;
import org.u2sa.vision.line.PaintSettings;
import org.u2sa.vision.line.PaintedDisc;
import org.u2sa.vision.line.PaintedLine;
import org.u2sa.vision.object.ObjectFinder;
import org.u2sa.vision.object.ObjectSettings;
import org.u2sa.vision.object.SeenObject;
import org.u2sa.vision.picture.Shades;

/**
 * Recognises what is on a course in one picture after another: lines, discs and objects. For one
 * thread; reuses its memory, so what it returns is read before the next picture is taken.
 */
public final class CourseSight {
  private final CourseSettings settings;
  private final Shades shades = new Shades();
  private final TopView top;
  private final PaintFinder paint;
  private final ObjectFinder objects;
  private boolean[] hidden = new boolean[0];

  /**
   * What one picture shows.
   *
   * @param view the picture's way to the ground
   * @param lines nearest first
   * @param discs that mark potholes
   * @param objects nearest first
   */
  public record Seen(
      GroundView view,
      List<PaintedLine> lines,
      List<PaintedDisc> discs,
      List<SeenObject> objects) {}

  /** Looks for what the settings say. */
  public CourseSight(CourseSettings settings) {
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
                settings.shortestLine(),
                settings.longestGap(),
                settings.longestPiece()),
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
                settings.farthestObject()),
            new GroundSigma(0.0, settings.tiltSigma(), settings.yawSigma(), settings.ownSigma()));
  }

  /**
   * Looks at a picture.
   *
   * @param frame with its pixels, not packed as JPEG
   * @param lens of a picture of this size
   * @param rollRad of the vehicle when it was taken, right side down positive
   * @param pitchRad of the vehicle, front up positive
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

  /** How well places on the ground are known with this lens. */
  public GroundSigma sigma(LensCalibration lens) {
    return new GroundSigma(
        settings.pixelSigma() / lens.pinhole().focalX(),
        settings.tiltSigma(),
        settings.yawSigma(),
        settings.ownSigma());
  }

  /** The ground from above, of the picture last looked at; for pictures of what is seen. */
  public TopView top() {
    return top;
  }

  /** How much each of its cells looks like paint, 0 not at all; unsigned. */
  public byte[] strength() {
    return paint.strength();
  }
}
