package org.u2sa.vision.camera;

import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.ServiceLoader;
import org.u2sa.device.Camera;
import org.u2sa.device.CameraFrame;
import org.u2sa.device.CameraFrame.PixelFormat;
import org.u2sa.device.CameraSensor;
import org.u2sa.device.MountingPose;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.service.ServiceContext;
import org.u2sa.vision.camera.CourseSight.Seen;
import org.u2sa.vision.ground.CameraMount;
import org.u2sa.vision.lens.CalibrationFile;
import org.u2sa.vision.lens.LensCalibration;
import org.u2sa.vision.picture.JpegDecoder;

/**
 * Sees white lines, potholes, barrels, sawhorses and flags on the ground (thesis 4.1.1.1). In:
 * state, for roll and pitch. Out: sensed-objects in BODY, with the time of the picture: lines as
 * PolyLine, potholes as Circle, the rest as Cylinder; their standard deviations grow with distance.
 */
public final class CourseCamera extends CameraSensor {
  private final CourseSettings settings;
  private final CameraMount mount;
  private final LensChoice lenses;
  private final CourseSight sight;
  private final SeenMessages messages;
  private final AttitudeHistory attitudes = new AttitudeHistory();
  private final Optional<JpegDecoder> jpeg;
  private long pictures;

  /** Called by the launcher: the camera is the one that the configuration names. */
  public CourseCamera(ServiceContext context) {
    super(context, "CourseCamera");
    settings = settings(CourseSettings.class).get();
    mount = CameraMount.of(settings(MountingPose.class).get(), settings.groundBelow());
    lenses = lenses(context);
    sight = new CourseSight(settings);
    messages = new SeenMessages(sensorName(), settings.lineWidth());
    jpeg = decoder();
    subscribe(Channels.STATE, attitudes::add);
  }

  /** With a camera that the host made: the phone's, a simulated one. */
  public CourseCamera(ServiceContext context, Camera camera) {
    super(context, "CourseCamera", camera);
    settings = settings(CourseSettings.class).get();
    mount = CameraMount.of(settings(MountingPose.class).get(), settings.groundBelow());
    lenses = lenses(context);
    sight = new CourseSight(settings);
    messages = new SeenMessages(sensorName(), settings.lineWidth());
    jpeg = decoder();
    subscribe(Channels.STATE, attitudes::add);
  }

  private LensChoice lenses(ServiceContext context) {
    if (mount.heightM() <= 0.0) {
      throw new BadInputException(
          String.format(
              "MOUNTED Z %.2f m and GROUND BELOW %.2f m: the camera is not above the ground",
              mount.place().z(), mount.groundBelowM()));
    }
    Optional<LensCalibration> calibrated =
        settings.calibration().isEmpty()
            ? Optional.empty()
            : Optional.of(
                CalibrationFile.read(context.configuration().resolve(settings.calibration())));
    return new LensChoice(calibrated, settings.angleOfView());
  }

  private static Optional<JpegDecoder> decoder() {
    Iterator<JpegDecoder> found = ServiceLoader.load(JpegDecoder.class).iterator();
    return found.hasNext() ? Optional.of(found.next()) : Optional.empty();
  }

  @Override
  protected void look(CameraFrame frame) {
    try {
      CameraFrame pixels = unpacked(frame);
      LensCalibration lens = lenses.of(pixels);
      long micros = frame.measuredAtMicros();
      boolean level = settings.levelGround();
      Seen seen =
          sight.look(
              pixels,
              lens,
              mount,
              level ? attitudes.roll(micros) : 0.0,
              level ? attitudes.pitch(micros) : 0.0);
      List<ObjectDescription> objects = messages.of(seen, sight.sigma(lens), micros);
      objects.forEach(object -> publish(Channels.SENSED_OBJECTS, object));
      pictures++;
      remark(
          "SEEN",
          String.format(
              "%d pictures; last %d lines, %d potholes, %d objects; camera %s",
              pictures, seen.lines().size(), seen.discs().size(), seen.objects().size(), lenses));
    } catch (BadInputException | IllegalArgumentException e) {
      trouble("the picture of " + frame + ": " + e.getMessage());
    }
  }

  private CameraFrame unpacked(CameraFrame frame) {
    if (frame.format() != PixelFormat.JPEG) {
      return frame;
    }
    return jpeg.orElseThrow(
            () -> new BadInputException("nothing on the class path unpacks JPEG pictures"))
        .decode(frame);
  }
}
