package org.u2sa.vision.camera;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectLevel;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.Circle;
import org.u2sa.messages.shape.Cylinder;
import org.u2sa.messages.shape.PolyLine;
import org.u2sa.vision.camera.CourseSight.Seen;
import org.u2sa.vision.ground.GroundSigma;
import org.u2sa.vision.ground.GroundView;
import org.u2sa.vision.line.PaintFinder.PaintedDisc;
import org.u2sa.vision.line.PaintFinder.PaintedLine;
import org.u2sa.vision.object.ObjectKind;
import org.u2sa.vision.object.SeenObject;

/**
 * Converts detections to Object Descriptions in BODY.
 *
 * @param sensorName detecting sensor; prefix of each UID
 */
public record SeenMessages(String sensorName, double lineWidthM) {
  public static final String LINE = "white line";

  public static final String POTHOLE = "pothole";

  /** Type reported for an image without detections. */
  public static final String NOTHING = "nothing";

  private static final double POLE_M = 0.05; // radius kept clear around a flag's pole
  private static final double DISC_CONFIDENCE = 0.8;

  /**
   * All detections, with the image's time [µs]. An image without detections yields one object of
   * type {@link #NOTHING} that is not an obstacle: it is negative evidence for maps and a sign of
   * life for monitoring.
   */
  public List<ObjectDescription> of(Seen seen, GroundSigma sigma, long micros) {
    List<ObjectDescription> messages = new ArrayList<>();
    GroundView view = seen.view();
    int number = 0;
    for (PaintedLine line : seen.lines()) {
      messages.add(named(line(line, view, sigma), LINE, ++number, micros));
    }
    number = 0;
    for (PaintedDisc disc : seen.discs()) {
      messages.add(named(disc(disc, view, sigma), POTHOLE, ++number, micros));
    }
    Map<ObjectKind, Integer> numbers = new EnumMap<>(ObjectKind.class);
    for (SeenObject object : seen.objects()) {
      int own = numbers.merge(object.kind(), 1, Integer::sum);
      messages.add(named(solid(object, view, sigma), object.kind().typeName(), own, micros));
    }
    if (messages.isEmpty()) {
      ObjectDescription nothing = new ObjectDescription().x(0.0).y(0.0);
      messages.add(named(nothing, NOTHING, 1, micros).level(ObjectLevel.HINDRANCE));
    }
    return messages;
  }

  private ObjectDescription named(ObjectDescription object, String type, int number, long micros) {
    object
        .uid(sensorName + " " + type + " " + number)
        .objectType(type)
        .referenceFrame(ReferenceFrame.BODY)
        .level(ObjectLevel.AVOID_ALWAYS)
        .sensorName(sensorName);
    object.timestamp(micros);
    return object;
  }

  private PolyLine line(PaintedLine line, GroundView view, GroundSigma sigma) {
    List<Point> points = new ArrayList<>(line.points().size());
    line.points().forEach(point -> points.add(view.toBody(point)));
    Point middle = line.points().get(line.points().size() / 2);
    PolyLine message = new PolyLine().width(lineWidthM).points(points);
    centred(message, middle, view, sigma.axes(way(middle, view), view.heightM()));
    message.confidence(line.support());
    return message;
  }

  private static Circle disc(PaintedDisc disc, GroundView view, GroundSigma sigma) {
    Circle message = new Circle().radius(disc.radiusM());
    centred(message, disc.centre(), view, sigma.axes(way(disc.centre(), view), view.heightM()));
    message.confidence(DISC_CONFIDENCE);
    return message;
  }

  private static Cylinder solid(SeenObject object, GroundView view, GroundSigma sigma) {
    boolean isFlag = object.kind() == ObjectKind.RED_FLAG || object.kind() == ObjectKind.BLUE_FLAG;
    Cylinder message = new Cylinder().radius(isFlag ? POLE_M : object.radiusM());
    message.height(object.heightM());
    // The cloth hangs on an unknown side of the pole.
    double across = isFlag ? Math.hypot(object.acrossM(), object.radiusM()) : object.acrossM();
    Point middle = object.foot().minus(Point.of(0.0, 0.0, 0.5 * object.heightM()));
    centred(message, middle, view, sigma.turned(way(object.foot(), view), object.alongM(), across));
    message.confidence(object.confidence());
    return message;
  }

  private static Point way(Point level, GroundView view) {
    return level.minus(view.camera());
  }

  private static void centred(
      ObjectDescription message, Point level, GroundView view, Point sigma) {
    Point body = view.toBody(level);
    message.x(body.x()).y(body.y()).z(body.z());
    message.motion().sigma(sigma);
  }
}
