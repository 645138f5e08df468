package org.u2sa.device.detection;

import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.u2sa.device.DeviceSensor;
import org.u2sa.device.Devices;
import org.u2sa.device.MountingPose;
import org.u2sa.device.SensorKind;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectLevel;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.SoughtObjects;
import org.u2sa.messages.marine.Hoop;
import org.u2sa.messages.marine.MarineObjects;
import org.u2sa.messages.shape.Box;
import org.u2sa.messages.shape.Rectangle;
import org.u2sa.service.ServiceContext;

/**
 * Publishes what an {@link ObjectDetector} recognises, in BODY (thesis 4.2.1.2). In: goals. With
 * ONLY SOUGHT, while every current goal names the types of objects that it looks for, only those
 * are published (thesis 4.3.2). Out: sensed-objects.
 */
public final class ObjectDetectorSensor extends DeviceSensor<ObjectDetector.Detections> {
  private static final SensorKind<ObjectDetector> KIND =
      new SensorKind<>(
          "ObjectDetectorSensor",
          ObjectDetector.class,
          new Devices.Usual("detector", "DETECTOR", "SIMULATED", ""),
          Channels.SENSED_OBJECTS,
          20.0, // Hz
          2.0); // s

  private record Variables(
      @Variable(ifAbsentText = "false")
          @Description(
              "Whether objects that no current goal looks for are left out. They are then not avoided either.")
          boolean onlySought,
      @Variable(unit = "s", min = 0, max = 10, ifAbsent = 0)
          @Description(
              "Time from the picture to the arrival of its objects, subtracted from their timestamps.")
          double delay) {}

  private final Settings<Variables> tuning = settings(Variables.class);
  private final MountingPose.Turn mounted = settings(MountingPose.class).get().turn();
  private Set<String> sought = new TreeSet<>(); // empty: everything
  private long published;
  private long leftOut;

  public ObjectDetectorSensor(ServiceContext context) {
    super(context, KIND);
    hearGoals();
  }

  public ObjectDetectorSensor(ServiceContext context, ObjectDetector detector) {
    super(context, KIND, detector);
    hearGoals();
  }

  private void hearGoals() {
    subscribe(Channels.GOALS, goals -> sought = SoughtObjects.of(goals));
  }

  @Override
  protected Stream<ObjectDescription> messages(ObjectDetector.Detections picture) {
    Stream.Builder<ObjectDescription> messages = Stream.builder();
    int number = 0;
    for (ObjectDetector.Detection detection : picture.detections()) {
      boolean isSought = sought.isEmpty() || sought.contains(detection.label());
      if (isSought || !tuning.get().onlySought()) {
        ObjectDescription message = message(detection, ++number);
        message.timestamp(picture.measuredAtMicros() - Clock.micros(tuning.get().delay()));
        messages.add(message);
        published++;
      } else {
        leftOut++;
      }
    }
    remark("SEEN", String.format(Locale.ROOT, "%d; not sought by the goal %d", published, leftOut));
    return messages.build();
  }

  private ObjectDescription message(ObjectDetector.Detection detection, int number) {
    double level = Math.cos(detection.elevationRad());
    Point way =
        Point.of(
            level * Math.cos(detection.bearingRad()),
            level * Math.sin(detection.bearingRad()),
            -Math.sin(detection.elevationRad()));
    Point body = mounted.toBody(way.times(detection.rangeM()));
    ObjectDescription object = MarineObjects.named(detection.label(), detection.radiusM());
    detection.axis().ifPresent(axis -> turn(object, direction(axis)));
    object
        .uid(sensorName() + " " + detection.label() + " " + number)
        .referenceFrame(ReferenceFrame.BODY)
        .x(body.x())
        .y(body.y())
        .z(body.z())
        .level(ObjectLevel.AVOID_ALWAYS)
        .sensorName(sensorName());
    object.motion().sigma(sigma(detection, direction(way)));
    return object;
  }

  /** Rotates a direction from the sensor's axes to the vehicle's. */
  private Point direction(Point way) {
    return mounted.toBody(way).minus(mounted.toBody(Point.ORIGIN));
  }

  private static void turn(ObjectDescription object, Point axis) {
    double psi = Math.atan2(axis.y(), axis.x());
    if (object instanceof Rectangle flat) {
      flat.psi(psi);
    } else if (object instanceof Box box) {
      box.psi(psi);
    } else if (object instanceof Hoop hoop) {
      hoop.psi(psi);
    }
  }

  /** Standard deviations along the vehicle's axes [m], of an ellipsoid along the line of sight. */
  private static Point sigma(ObjectDetector.Detection detection, Point way) {
    double along = detection.rangeSigmaM();
    double across = detection.angleSigmaRad() * detection.rangeM();
    return Point.of(
        axis(way.x(), along, across), axis(way.y(), along, across), axis(way.z(), along, across));
  }

  private static double axis(double cosine, double along, double across) {
    double sineSquared = Math.max(0.0, 1.0 - cosine * cosine);
    return Math.sqrt(cosine * cosine * along * along + sineSquared * across * across);
  }
}
