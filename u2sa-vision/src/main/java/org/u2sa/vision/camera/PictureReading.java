package org.u2sa.vision.camera;

import java.nio.file.Path;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.ServiceLoader;
import java.util.function.Function;
import org.u2sa.device.MountingPose;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.device.port.CameraFrame.PixelFormat;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.vision.camera.CourseSight.Seen;
import org.u2sa.vision.ground.CameraMount;
import org.u2sa.vision.ground.ClimbedHeight;
import org.u2sa.vision.ground.GroundSigma.SlopeSigma;
import org.u2sa.vision.lens.CalibrationFile;
import org.u2sa.vision.lens.LensCalibration;
import org.u2sa.vision.picture.JpegDecoder;

/**
 * Processes the images of one configured camera: decodes them, applies lens and mounting, and
 * converts detections to messages. Not thread-safe.
 */
public final class PictureReading {
  private static final double UNIFORM = Math.sqrt(12.0); // range over standard deviation

  private final CourseVariables settings;
  private final CameraMount mount;
  private final LensChoice lenses;
  private final CourseSight sight;
  private final SeenMessages messages;
  private final Optional<JpegDecoder> jpeg;

  /**
   * @param sensorName sensor name for the messages
   * @param resolve resolves file names in the configuration
   * @throws BadInputException if the calibration file is wrong, or the camera below the ground
   */
  public PictureReading(
      CourseVariables settings,
      MountingPose mounted,
      String sensorName,
      Function<String, Path> resolve) {
    this.settings = settings;
    mount = CameraMount.of(mounted, settings.groundBelow());
    if (mount.heightM() <= 0.0) {
      throw new BadInputException(
          String.format(
              "MOUNTED Z %.2f m, GROUND BELOW %.2f m: the camera is not above the ground",
              mounted.z(), settings.groundBelow()));
    }
    Optional<LensCalibration> calibrated =
        settings.calibration().isEmpty()
            ? Optional.empty()
            : Optional.of(CalibrationFile.read(resolve.apply(settings.calibration())));
    lenses = new LensChoice(calibrated, settings.angleOfView());
    sight = new CourseSight(settings);
    messages = new SeenMessages(sensorName, settings.lineWidth());
    Iterator<JpegDecoder> found = ServiceLoader.load(JpegDecoder.class).iterator();
    jpeg = found.hasNext() ? Optional.of(found.next()) : Optional.empty();
  }

  /**
   * Detects objects in an image.
   *
   * @param rollRad of the vehicle when it was taken, right side down positive
   * @param pitchRad of the vehicle, front up positive
   * @param climbedM by {@link ClimbedHeight}: the ground lies between the wheels' height and this
   *     much below
   * @throws BadInputException if it cannot be decoded
   * @throws IllegalArgumentException if its aspect ratio differs from the calibration's
   */
  public Seen read(CameraFrame frame, double rollRad, double pitchRad, double climbedM) {
    CameraFrame pixels = unpacked(frame);
    boolean tilts = settings.levelGround();
    return sight.look(
        pixels,
        lenses.of(pixels),
        mount.withGroundLower(0.5 * climbedM),
        tilts ? rollRad : 0.0,
        tilts ? pitchRad : 0.0);
  }

  /**
   * Converts detections to messages in BODY with the image's time [µs]. Positions are less certain
   * on a slope.
   *
   * @param rollRad of the vehicle when it was taken, right side down positive
   * @param pitchRad of the vehicle, front up positive
   * @param climbedM as for {@link #read}
   */
  public List<ObjectDescription> messages(
      Seen seen, double rollRad, double pitchRad, double climbedM, long micros) {
    double slope = SlopeSigma.rad(settings.slopeAbove(), rollRad, pitchRad);
    double height = climbedM / UNIFORM;
    return messages.of(seen, sight.sigma(seen.view().lens()).uneven(slope, height), micros);
  }

  public CameraFrame unpacked(CameraFrame frame) {
    if (frame.format() != PixelFormat.JPEG) {
      return frame;
    }
    return jpeg.orElseThrow(() -> new BadInputException("no JPEG decoder on the class path"))
        .decode(frame);
  }

  /** The detector; its bird's-eye view is that of the last image. */
  public CourseSight sight() {
    return sight;
  }

  public LensChoice lens() {
    return lenses;
  }
}
