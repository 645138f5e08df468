package org.u2sa.vision.camera;

import org.u2sa.device.Camera;
import org.u2sa.device.CameraFrame;
import org.u2sa.device.CameraSensor;
import org.u2sa.device.MountingPose;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.service.ServiceContext;
import org.u2sa.vision.camera.CourseSight.Seen;
import org.u2sa.vision.ground.AttitudeHistory;

/**
 * Sees white lines, potholes, barrels, sawhorses and flags on the ground (thesis 4.1.1.1). In:
 * state, for roll and pitch. Out: sensed-objects in BODY, with the time of the picture: lines as
 * PolyLine, potholes as Circle, the rest as Cylinder; their standard deviations grow with distance.
 * Of a picture without any of these: one ObjectDescription of type {@link SeenMessages#NOTHING}.
 */
public final class CourseCamera extends CameraSensor {
  private final AttitudeHistory attitudes = new AttitudeHistory();
  private final PictureReading reading;
  private long pictures;

  /** Called by the launcher: the camera is the one that the configuration names. */
  public CourseCamera(ServiceContext context) {
    super(context, "CourseCamera");
    reading = reading(context);
  }

  /** With a camera that the host made: the phone's, a simulated one. */
  public CourseCamera(ServiceContext context, Camera camera) {
    super(context, "CourseCamera", camera);
    reading = reading(context);
  }

  private PictureReading reading(ServiceContext context) {
    subscribe(Channels.STATE, attitudes::add);
    return new PictureReading(
        settings(CourseSettings.class).get(),
        settings(MountingPose.class).get(),
        sensorName(),
        context.configuration()::resolve);
  }

  @Override
  protected void look(CameraFrame frame) {
    long micros = frame.measuredAtMicros();
    try {
      Seen seen = reading.read(frame, attitudes.roll(micros), attitudes.pitch(micros));
      reading.messages(seen, micros).forEach(each -> publish(Channels.SENSED_OBJECTS, each));
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
}
