package org.u2sa.scenarios.camera;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.messages.frame.Point;
import org.u2sa.vision.camera.CourseSight;
import org.u2sa.vision.camera.CourseSight.Seen;
import org.u2sa.vision.ground.GroundView;
import org.u2sa.vision.ground.TopView;
import org.u2sa.vision.lens.LensCalibration.Spot;
import org.u2sa.vision.line.PaintFinder.PaintedDisc;
import org.u2sa.vision.line.PaintFinder.PaintedLine;
import org.u2sa.vision.object.ObjectKind;
import org.u2sa.vision.object.SeenObject;

/** A camera image with detections, beside a bird's-eye view of the ground. */
public final class SeenPicture {
  private static final Color LINE = new Color(0xFFD400);
  private static final Color DISC = new Color(0xFF40FF);
  private static final Color OBJECT = new Color(0x00E5FF);
  private static final int UNSEEN = 0x101830;
  private static final int PAINT = 0xFF6000;
  private static final int CORNERS = 32;

  private final Seen seen;
  private final TopView top;
  private final BufferedImage image;
  private final Graphics2D pen;
  private final int left; // first column of the bird's-eye view
  private final double scale; // scale of that view: pixels per cell

  private SeenPicture(CameraFrame frame, Seen seen, CourseSight sight) {
    this.seen = seen;
    top = sight.top();
    left = frame.width();
    scale = (double) frame.height() / top.area().rows();
    int width = left + (int) Math.ceil(scale * top.area().columns());
    image = new BufferedImage(width, frame.height(), BufferedImage.TYPE_INT_RGB);
    pen = image.createGraphics();
    pen.drawImage(CameraPicture.image(frame), 0, 0, null);
    ground(sight.strength());
    pen.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    pen.setStroke(new BasicStroke(2.0f));
  }

  /**
   * Draws the detections.
   *
   * @param frame uncompressed frame
   * @param sight detector that last processed the frame
   */
  public static BufferedImage of(CameraFrame frame, Seen seen, CourseSight sight) {
    SeenPicture picture = new SeenPicture(frame, seen, sight);
    picture.lines();
    picture.discs();
    picture.objects();
    picture.pen.dispose();
    return picture.image;
  }

  private void ground(byte[] strength) {
    int columns = top.area().columns();
    for (int y = 0; y < image.getHeight(); y++) {
      int row = top.area().rows() - 1 - (int) (y / scale);
      for (int x = left; x < image.getWidth(); x++) {
        int at = row * columns + Math.min(columns - 1, (int) ((x - left) / scale));
        int shade = top.white()[at] & 0xFF;
        int colour = strength[at] != 0 ? PAINT : shade << 16 | shade << 8 | shade;
        image.setRGB(x, y, top.seen()[at] ? colour : UNSEEN);
      }
    }
  }

  private void lines() {
    pen.setColor(LINE);
    for (PaintedLine line : seen.lines()) {
      draw(line.points());
    }
  }

  /** Draws a polyline in both views. */
  private void draw(List<Point> places) {
    Path2D inPicture = new Path2D.Double();
    Path2D fromAbove = new Path2D.Double();
    boolean isFirst = true;
    for (Point place : places) {
      add(fromAbove, above(place));
      Optional<Spot> pixel = seen.view().pixel(place);
      if (pixel.isPresent()) {
        if (isFirst) {
          inPicture.moveTo(pixel.get().x(), pixel.get().y());
          isFirst = false;
        } else {
          inPicture.lineTo(pixel.get().x(), pixel.get().y());
        }
      }
    }
    pen.setClip(0, 0, left, image.getHeight());
    pen.draw(inPicture);
    pen.setClip(left, 0, image.getWidth() - left, image.getHeight());
    pen.draw(fromAbove);
    pen.setClip(null);
  }

  private static void add(Path2D path, Spot to) {
    if (path.getCurrentPoint() == null) {
      path.moveTo(to.x(), to.y());
    } else {
      path.lineTo(to.x(), to.y());
    }
  }

  private Spot above(Point level) {
    TopView.Area area = top.area();
    return new Spot(
        left + scale * (level.y() + area.sideM()) / area.cellM(),
        image.getHeight() - scale * (level.x() - area.nearM()) / area.cellM());
  }

  private void discs() {
    pen.setColor(DISC);
    for (PaintedDisc disc : seen.discs()) {
      draw(circle(seen.view(), disc.centre(), disc.radiusM()));
      label(disc.centre(), "pothole");
    }
  }

  private static List<Point> circle(GroundView view, Point centre, double radius) {
    Point[] corners = new Point[CORNERS + 1];
    for (int i = 0; i <= CORNERS; i++) {
      double angle = 2.0 * Math.PI * i / CORNERS;
      corners[i] =
          view.onGround(
              centre.x() + radius * Math.cos(angle), centre.y() + radius * Math.sin(angle));
    }
    return List.of(corners);
  }

  private void label(Point place, String text) {
    seen.view()
        .pixel(place)
        .ifPresent(pixel -> pen.drawString(text, (float) pixel.x(), (float) pixel.y()));
  }

  private void objects() {
    for (SeenObject object : seen.objects()) {
      boolean isRed = object.kind() == ObjectKind.RED_FLAG;
      pen.setColor(isRed ? Color.RED : OBJECT);
      int wide = object.right() - object.left();
      pen.drawRect(object.left(), object.top(), wide, object.bottom() - object.top());
      String text =
          String.format(
              Locale.ROOT,
              "%s %.1f m",
              object.kind().typeName(),
              Math.hypot(object.foot().x(), object.foot().y()));
      pen.drawString(text, object.left(), Math.max(12, object.top() - 4));
      Spot above = above(object.foot());
      double radius = Math.max(2.0, scale * object.radiusM() / top.area().cellM());
      pen.setClip(left, 0, image.getWidth() - left, image.getHeight());
      pen.draw(
          new Ellipse2D.Double(above.x() - radius, above.y() - radius, 2 * radius, 2 * radius));
      pen.setClip(null);
    }
  }
}
