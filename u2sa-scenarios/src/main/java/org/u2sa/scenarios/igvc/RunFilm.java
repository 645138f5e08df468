package org.u2sa.scenarios.igvc;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.PlannedPath;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.Circle;
import org.u2sa.messages.shape.Cylinder;
import org.u2sa.messages.shape.Line;
import org.u2sa.report.ReportFile;
import org.u2sa.report.picture.Animation;
import org.u2sa.report.picture.PictureFile;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.LocalPlane;

/**
 * Samples the run every second and writes pictures: {@code course.png}, the entire run from above,
 * and {@code run.gif}, an animation. Not thread-safe.
 */
final class RunFilm {
  private static final double EVERY_S = 1.0;
  private static final int PICTURE = 1400; // pixels
  private static final int FILM = 560;
  private static final int HUNDREDTHS = 8; // of a second per frame
  private static final double SURE = 0.9; // confidence of observed lines, as opposed to closed gaps

  private final Course course;
  private final VehicleOutline outline;
  private final LocalPlane plane;
  private final Path directory;
  private final List<Moment> moments = new ArrayList<>();
  private final List<Point> track = new ArrayList<>();
  private List<Point> plan = List.of();
  private List<Seen> seen = List.of();
  private double nextS;

  /** A line or outline from the World Modeler. */
  record Seen(List<Point> points, boolean closesGap) {}

  /** A moment of the run. */
  record Moment(Point at, double headingRad, int trackPoints, List<Point> plan, List<Seen> seen) {}

  RunFilm(Course course, VehicleOutline outline, Geodetic origin, Path directory) {
    this.course = course;
    this.outline = outline;
    plane = new LocalPlane(origin);
    this.directory = directory;
  }

  void see(VehicleTruth truth) {
    if (truth.timeS() < nextS) {
      return;
    }
    nextS = truth.timeS() + EVERY_S;
    track.add(truth.position());
    moments.add(new Moment(truth.position(), truth.headingRad(), track.size(), plan, seen));
  }

  /** Latest moment; empty before the first. */
  Optional<Moment> newest() {
    return moments.isEmpty() ? Optional.empty() : Optional.of(moments.get(moments.size() - 1));
  }

  /** Track of the vehicle. */
  List<Point> track() {
    return track;
  }

  void plan(PlannedPath path) {
    plan = place(path.points(), path.referenceFrame());
  }

  void objects(ObjectList list) {
    List<Seen> now = new ArrayList<>();
    for (ObjectDescription object : list.objects()) {
      if (object instanceof Line line) {
        boolean closes = line.confidence().orElse(1.0) < SURE;
        now.add(new Seen(place(line.points(), line.referenceFrame()), closes));
      } else {
        Point at =
            place(List.of(object.center()), object.referenceFrame()).stream()
                .findFirst()
                .orElse(Point.ORIGIN);
        now.add(new Seen(ring(at, radiusM(object)), false));
      }
    }
    seen = now;
  }

  private static double radiusM(ObjectDescription object) {
    if (object instanceof Circle circle) {
      return circle.radius();
    }
    return object instanceof Cylinder cylinder ? cylinder.radius() : 0.1;
  }

  private static List<Point> ring(Point middle, double radiusM) {
    List<Point> points = new ArrayList<>();
    for (int i = 0; i <= 12; i++) {
      double angle = 2.0 * Math.PI * i / 12;
      points.add(
          Point.of(
              middle.x() + radiusM * Math.cos(angle), middle.y() + radiusM * Math.sin(angle), 0.0));
    }
    return points;
  }

  /** Converts points of a frame to the course; empty if the frame is not global. */
  List<Point> place(List<Point> points, ReferenceFrame frame) {
    return frame.isEarth()
        ? points.stream().map(point -> plane.point(Geodetic.of(point))).toList()
        : List.of();
  }

  /** Writes the pictures. */
  void write() {
    if (moments.isEmpty()) {
      return;
    }
    ReportFile.write(
        directory.resolve("course.png"),
        out -> {
          CoursePainter painter = CoursePainter.whole(course, outline, PICTURE);
          BufferedImage image = painter.course();
          painter.moment(image, moments.get(moments.size() - 1), track);
          PictureFile.png(out, image);
        });
    ReportFile.write(
        directory.resolve("run.gif"),
        out -> {
          CoursePainter painter = CoursePainter.whole(course, outline, FILM);
          BufferedImage empty = painter.course();
          try (Animation animation = new Animation(out, HUNDREDTHS)) {
            for (Moment moment : moments) {
              BufferedImage image = Animation.copyOf(empty);
              painter.moment(image, moment, track.subList(0, moment.trackPoints()));
              animation.add(image);
            }
          }
        });
  }
}
