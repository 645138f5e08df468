package org.u2sa.scenarios.igvc;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.shape.Box;
import org.u2sa.messages.shape.Circle;
import org.u2sa.messages.shape.Cylinder;
import org.u2sa.messages.shape.Line;
import org.u2sa.messages.shape.PolyLine;
import org.u2sa.report.ReportFile;
import org.u2sa.sim.camera.Scenery;
import org.u2sa.world.xml.WorldFile;

/** Courses as world XML files. */
final class CourseFile {
  private CourseFile() {}

  /**
   * Reads a course.
   *
   * @throws org.u2sa.interfaces.BadInputException naming file, line, element, value and what was
   *     expected
   */
  static Course read(Path file) {
    return new Course(file.toString(), WorldFile.load(file).objects());
  }

  /** Writes a course that {@link #read} restores identically. */
  static void write(Course course, Path file) {
    ReportFile.writeText(file, out -> out.write(text(course)));
  }

  private static String text(Course course) {
    StringBuilder text = new StringBuilder("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    text.append("<!-- IGVC ").append(course.origin());
    text.append(": metres east and north of the course's origin. Types: docs/igvc.md. -->\n");
    text.append("<world>\n  <reference>Local ENU</reference>\n");
    for (ObjectDescription object : course.objects()) {
      text.append("  <").append(object.type().name()).append('>');
      element(text, "uid", object.uid());
      element(text, "type", object.objectType());
      if (object instanceof Line line) {
        List<String> points = new ArrayList<>();
        for (Point point : line.points()) {
          String up = object.objectType().equals(Scenery.RAMP) ? " " + number(point.z()) : "";
          points.add(number(point.x()) + " " + number(point.y()) + up);
        }
        element(text, "points", String.join("; ", points));
      } else {
        element(text, "x", number(object.x()));
        element(text, "y", number(object.y()));
        element(text, "z", number(object.z()));
      }
      shape(text, object);
      text.append("</").append(object.type().name()).append(">\n");
    }
    return text.append("</world>\n").toString();
  }

  private static void shape(StringBuilder text, ObjectDescription object) {
    if (object instanceof PolyLine line) {
      element(text, "width", number(line.width()));
    } else if (object instanceof Circle circle) {
      element(text, "radius", number(circle.radius()));
    } else if (object instanceof Cylinder cylinder) {
      element(text, "radius", number(cylinder.radius()));
      element(text, "height", number(cylinder.height()));
    } else if (object instanceof Box box) {
      element(text, "length", number(box.length()));
      element(text, "width", number(box.width()));
      element(text, "height", number(box.height()));
      element(text, "psi", String.format(Locale.ROOT, "%.6f", box.psi()));
    }
  }

  private static String number(double metres) {
    return String.format(Locale.ROOT, "%.4f", metres);
  }

  private static void element(StringBuilder text, String name, String value) {
    text.append('<').append(name).append('>').append(value);
    text.append("</").append(name).append('>');
  }
}
