package org.u2sa.vision.camera;

import java.util.Optional;
import org.u2sa.device.CameraSensor;
import org.u2sa.device.MountingPose;
import org.u2sa.device.port.Camera;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.service.ServiceContext;
import org.u2sa.vision.camera.CourseSight.Seen;
import org.u2sa.vision.ground.AttitudeHistory;
import org.u2sa.vision.ground.ClimbedHeight;

/**
 * Detects white lines, potholes, barrels, sawhorses and flags on the ground (thesis 4.1.1.1). In:
 * state, for roll and pitch. Out: sensed-objects in BODY, with the time of the image: lines as
 * PolyLine, potholes as Circle, the rest as Cylinder; standard deviations grow with distance. An
 * image without detections yields one ObjectDescription of type {@link SeenMessages#NOTHING}. Out:
 * images (the camera image, every IMAGE EVERY seconds if set).
 */
public final class CourseCamera extends CameraSensor {
  private record Showing(
      @Variable(unit = "s", min = 0, max = 3600, ifAbsent = 0)
          @Description(
              "Interval of JPEG pictures published on images, for recordings and displays; 0: none.")
          double imageEvery) {}

  private final AttitudeHistory attitudes = new AttitudeHistory();
  private final ClimbedHeight climbed;
  private final PictureReading reading;
  private final Optional<CameraImages> images; // empty: not published
  private long pictures;

  public CourseCamera(ServiceContext context) {
    super(context, "CourseCamera");
    climbed = new ClimbedHeight(settings(CourseVariables.class).get().slopeAbove());
    reading = reading(context);
    images = images();
  }

  public CourseCamera(ServiceContext context, Camera camera) {
    super(context, "CourseCamera", camera);
    climbed = new ClimbedHeight(settings(CourseVariables.class).get().slopeAbove());
    reading = reading(context);
    images = images();
  }

  private PictureReading reading(ServiceContext context) {
    subscribe(
        Channels.STATE,
        state -> {
          attitudes.add(state);
          climbed.add(state);
        });
    return new PictureReading(
        settings(CourseVariables.class).get(),
        settings(MountingPose.class).get(),
        sensorName(),
        context.configuration()::resolve);
  }

  private Optional<CameraImages> images() {
    double everyS = settings(Showing.class).get().imageEvery();
    if (everyS == 0.0) {
      return Optional.empty();
    }
    registerPublisher(Channels.IMAGES);
    return Optional.of(new CameraImages(sensorName(), everyS));
  }

  @Override
  protected void look(CameraFrame frame) {
    show(frame);
    long micros = frame.measuredAtMicros();
    try {
      double roll = attitudes.roll(micros);
      double pitch = attitudes.pitch(micros);
      double height = climbed.metres();
      Seen seen = reading.read(frame, roll, pitch, height);
      reading
          .messages(seen, roll, pitch, height, micros)
          .forEach(each -> publish(Channels.SENSED_OBJECTS, each));
      pictures++;
      remark(
          "SEEN",
          String.format(
              "%d pictures; last %d lines, %d potholes, %d objects; camera %s",
              pictures,
              seen.lines().size(),
              seen.discs().size(),
              seen.objects().size(),
              reading.lens()));
    } catch (BadInputException | IllegalArgumentException e) {
      trouble("a picture of " + frame + ": " + e.getMessage());
    }
  }

  private void show(CameraFrame frame) {
    try {
      images.flatMap(each -> each.of(frame)).ifPresent(each -> publish(Channels.IMAGES, each));
    } catch (IllegalArgumentException e) {
      trouble("a picture of " + frame + " to publish: " + e.getMessage());
    }
  }
}
