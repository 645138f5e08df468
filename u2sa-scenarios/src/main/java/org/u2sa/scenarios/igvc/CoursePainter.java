package org.u2sa.scenarios.igvc;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.List;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.Box;
import org.u2sa.messages.shape.Circle;
import org.u2sa.messages.shape.Cylinder;
import org.u2sa.messages.shape.Line;
import org.u2sa.sim.camera.Scenery;
import org.u2sa.sim.world.Ramp;

/** Draws a course from above, north up, with the vehicle's track, plan and detections. */
final class CoursePainter {
  private static final double MARGIN_M = 2.0;
  private static final Color GRASS = new Color(0x4B, 0x7A, 0x3A);
  private static final int[] BOARDS = {0xC8, 0xA8, 0x78}; // RGB at the top
  private static final double PLANK_M = 0.2;
  private static final Color WORN = new Color(255, 255, 255, 120);
  private static final Color SEEN = new Color(0x20, 0x50, 0xE0);
  private static final Color CLOSED = new Color(0x20, 0x50, 0xE0, 130);
  private static final Color PLANNED = new Color(0xFF, 0xE0, 0x20);
  private static final Color TRACK = new Color(0x10, 0x10, 0x10);

  private static final Color OCCUPIED = new Color(0x60, 0x00, 0x20, 200);
  private static final Color FREE = new Color(255, 255, 255, 40);

  private final Course course;
  private final VehicleOutline outline;
  private final int width;
  private final int height;
  private final AffineTransform toPixels;
  private final double scale;

  private CoursePainter(Course course, VehicleOutline outline, double[] window, int longest) {
    this.course = course;
    this.outline = outline;
    double east = window[2];
    double north = window[3];
    scale = longest / Math.max(east - window[0], north - window[1]);
    width = (int) Math.ceil((east - window[0]) * scale);
    height = (int) Math.ceil((north - window[1]) * scale);
    toPixels = new AffineTransform(scale, 0.0, 0.0, -scale, -window[0] * scale, north * scale);
  }

  /**
   * Draws the whole course.
   *
   * @param longest longer side of the picture [px]
   */
  static CoursePainter whole(Course course, VehicleOutline outline, int longest) {
    double west = Double.POSITIVE_INFINITY;
    double south = Double.POSITIVE_INFINITY;
    double east = Double.NEGATIVE_INFINITY;
    double north = Double.NEGATIVE_INFINITY;
    for (ObjectDescription object : course.objects()) {
      List<Point> points = object instanceof Line line ? line.points() : List.of(object.center());
      for (Point point : points) {
        west = Math.min(west, point.x() - MARGIN_M);
        east = Math.max(east, point.x() + MARGIN_M);
        south = Math.min(south, point.y() - MARGIN_M);
        north = Math.max(north, point.y() + MARGIN_M);
      }
    }
    return new CoursePainter(course, outline, new double[] {west, south, east, north}, longest);
  }

  /** Draws a square around a position, given its half width [m] and its size [px]. */
  static CoursePainter around(
      Course course, VehicleOutline outline, Point at, double reachM, int pixels) {
    return new CoursePainter(
        course,
        outline,
        new double[] {at.x() - reachM, at.y() - reachM, at.x() + reachM, at.y() + reachM},
        pixels);
  }

  /** Creates a new picture of the course. */
  BufferedImage course() {
    BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
    Graphics2D graphics = on(image);
    graphics.setColor(GRASS);
    graphics.fill(new Rectangle2D.Double(-1.0e4, -1.0e4, 2.0e4, 2.0e4));
    course.ramps().forEach(placed -> draw(graphics, placed.ramp()));
    for (ObjectDescription object : course.objects()) {
      draw(graphics, object);
    }
    graphics.dispose();
    return image;
  }

  private Graphics2D on(BufferedImage image) {
    Graphics2D graphics = image.createGraphics();
    graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    graphics.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
    graphics.transform(toPixels);
    return graphics;
  }

  /** Ramp boards, brighter with height. */
  private void draw(Graphics2D graphics, Ramp ramp) {
    Path2D boards = new Path2D.Double();
    for (double along = 0.0; along <= ramp.lengthM(); along += PLANK_M) {
      double end = Math.min(ramp.lengthM(), along + PLANK_M);
      double bright = 0.55 + 0.45 * ramp.at(0.5 * (along + end), 0.0).z() / ramp.highestM();
      graphics.setColor(
          new Color(
              (int) (BOARDS[0] * bright), (int) (BOARDS[1] * bright), (int) (BOARDS[2] * bright)));
      boards.reset();
      double half = 0.5 * ramp.widthM();
      double[][] corners = {{along, -half}, {end, -half}, {end, half}, {along, half}};
      for (int i = 0; i < corners.length; i++) {
        Point at = ramp.at(corners[i][0], corners[i][1]);
        if (i == 0) {
          boards.moveTo(at.x(), at.y());
        } else {
          boards.lineTo(at.x(), at.y());
        }
      }
      boards.closePath();
      graphics.fill(boards);
    }
  }

  private void draw(Graphics2D graphics, ObjectDescription object) {
    switch (object.objectType()) {
      case Scenery.LINE -> stroke(graphics, ((Line) object).points(), Color.WHITE, 0.1);
      case Scenery.WORN_LINE -> stroke(graphics, ((Line) object).points(), WORN, 0.1);
      case Course.BOUNDARY, Course.END, Course.START, Course.FENCE, Scenery.RAMP -> {
        // invisible, or (ramps) already drawn below all else
      }
      case Course.WAYPOINT -> {
        graphics.setColor(Color.CYAN);
        graphics.setStroke(new BasicStroke((float) (1.5 / scale)));
        graphics.draw(disc(object, ((Circle) object).radius()));
      }
      default -> {
        graphics.setColor(colour(object.objectType()));
        if (object instanceof Cylinder cylinder) {
          graphics.fill(disc(object, Math.max(0.15, cylinder.radius())));
        } else if (object instanceof Circle circle) {
          graphics.fill(disc(object, circle.radius()));
        } else if (object instanceof Box box) {
          AffineTransform before = graphics.getTransform();
          graphics.translate(box.x(), box.y());
          graphics.rotate(box.psi());
          graphics.fill(
              new Rectangle2D.Double(
                  -0.5 * box.length(), -0.5 * box.width(), box.length(), box.width()));
          graphics.setTransform(before);
        }
      }
    }
  }

  private static Color colour(String type) {
    return switch (type) {
      case Scenery.BARREL -> new Color(0xF0, 0x70, 0x10);
      case Scenery.SAWHORSE -> new Color(0xF0, 0xB0, 0x60);
      case Scenery.RED_FLAG -> Color.RED;
      case Scenery.BLUE_FLAG -> Color.BLUE;
      case Scenery.POTHOLE -> Color.WHITE;
      default -> Color.GRAY;
    };
  }

  private static Ellipse2D disc(ObjectDescription object, double radius) {
    return new Ellipse2D.Double(
        object.x() - radius, object.y() - radius, 2.0 * radius, 2.0 * radius);
  }

  private static void stroke(Graphics2D graphics, List<Point> points, Color colour, double widthM) {
    if (points.size() < 2) {
      return;
    }
    graphics.setColor(colour);
    graphics.setStroke(
        new BasicStroke((float) widthM, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
    Path2D path = new Path2D.Double();
    path.moveTo(points.get(0).x(), points.get(0).y());
    points.forEach(point -> path.lineTo(point.x(), point.y()));
    graphics.draw(path);
  }

  /**
   * Adds the occupied (dark) and free (light) cells of a grid.
   *
   * @param place converts points of a frame to the course; empty if impossible
   */
  void grid(BufferedImage image, OccupancyGrid grid, Placing place) {
    Graphics2D graphics = on(image);
    double edge = grid.resolution();
    for (int row = 0; row < grid.rows(); row++) {
      for (int column = 0; column < grid.columns(); column++) {
        byte cell = grid.cell(column, row);
        if (cell != OccupancyGrid.UNKNOWN && cell != 0) {
          graphics.setColor(cell > 0 ? OCCUPIED : FREE);
          for (Point at : place.of(List.of(grid.centerOf(column, row)), grid.referenceFrame())) {
            graphics.fill(
                new Rectangle2D.Double(at.x() - 0.5 * edge, at.y() - 0.5 * edge, edge, edge));
          }
        }
      }
    }
    graphics.dispose();
  }

  /** Converts points of a frame to the course. */
  interface Placing {
    List<Point> of(List<Point> points, ReferenceFrame frame);
  }

  /** Adds the vehicle's detections and plan at a moment, and its track. */
  void moment(BufferedImage image, RunFilm.Moment moment, List<Point> track) {
    Graphics2D graphics = on(image);
    for (RunFilm.Seen seen : moment.seen()) {
      stroke(graphics, seen.points(), seen.closesGap() ? CLOSED : SEEN, 1.5 / scale);
    }
    stroke(graphics, track, TRACK, 2.0 / scale);
    stroke(graphics, moment.plan(), PLANNED, 2.0 / scale);
    graphics.translate(moment.at().x(), moment.at().y());
    graphics.rotate(0.5 * Math.PI - moment.headingRad());
    graphics.setColor(Color.BLACK);
    graphics.fill(
        new Rectangle2D.Double(
            -outline.rearM(),
            -0.5 * outline.widthM(),
            outline.frontM() + outline.rearM(),
            outline.widthM()));
    graphics.setColor(PLANNED);
    graphics.fill(new Rectangle2D.Double(outline.frontM() - 0.15, -0.2, 0.15, 0.4));
    graphics.dispose();
  }
}
