package org.u2sa.vision.marine;

import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.ServiceLoader;
import java.util.Set;
import org.u2sa.device.CameraSensor;
import org.u2sa.device.MountingPose;
import org.u2sa.device.port.Camera;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.frame.Rotation;
import org.u2sa.service.ServiceContext;
import org.u2sa.vision.camera.LensChoice;
import org.u2sa.vision.ground.AttitudeHistory;
import org.u2sa.vision.ground.CameraMount;
import org.u2sa.vision.lens.CalibrationFile;
import org.u2sa.vision.lens.LensCalibration;
import org.u2sa.vision.picture.JpegDecoder;

/**
 * Detects buoys, poles, hoops, buttons, docks, bins and path markers by colour, shape and apparent
 * size, above and under water, but only those needed by the current goals (thesis 4.2.1.2, 4.3.2).
 * In: goals; state, for roll and pitch above water; both optional. Out: sensed-objects in BODY,
 * with the time of the image; types are such as "red buoy". Health reports what was skipped.
 */
public final class MarineCamera extends CameraSensor {
  private final AttitudeHistory attitudes = new AttitudeHistory();
  private final SoughtKinds sought;
  private final LensChoice lenses;
  private final MarineSight sight;
  private final MarineMessages messages;
  private final Optional<JpegDecoder> jpeg;
  private int seenLast;

  public MarineCamera(ServiceContext context) {
    super(context, "MarineCamera");
    MarineVariables variables = settings(MarineVariables.class).get();
    sought = sought(variables);
    lenses = lenses(variables, context);
    CameraMount mount = CameraMount.of(settings(MountingPose.class).get(), 0.0);
    sight = new MarineSight(variables, mount);
    messages = new MarineMessages(sensorName(), variables, mount, variables.angleSigma());
    jpeg = decoder();
  }

  public MarineCamera(ServiceContext context, Camera camera) {
    super(context, "MarineCamera", camera);
    MarineVariables variables = settings(MarineVariables.class).get();
    sought = sought(variables);
    lenses = lenses(variables, context);
    CameraMount mount = CameraMount.of(settings(MountingPose.class).get(), 0.0);
    sight = new MarineSight(variables, mount);
    messages = new MarineMessages(sensorName(), variables, mount, variables.angleSigma());
    jpeg = decoder();
  }

  private SoughtKinds sought(MarineVariables variables) {
    SoughtKinds kinds =
        new SoughtKinds(variables.kinds(), variables.always(), variables.kindsByGoal());
    subscribe(Channels.STATE, attitudes::add);
    subscribe(Channels.GOALS, kinds::goals);
    return kinds;
  }

  private static LensChoice lenses(MarineVariables variables, ServiceContext context) {
    Optional<LensCalibration> calibrated =
        variables.calibration().isEmpty()
            ? Optional.empty()
            : Optional.of(
                CalibrationFile.read(context.configuration().resolve(variables.calibration())));
    return new LensChoice(calibrated, variables.angleOfView());
  }

  private static Optional<JpegDecoder> decoder() {
    Iterator<JpegDecoder> found = ServiceLoader.load(JpegDecoder.class).iterator();
    return found.hasNext() ? Optional.of(found.next()) : Optional.empty();
  }

  @Override
  protected void look(CameraFrame frame) {
    Set<MarineKind> kinds = sought.next();
    try {
      if (!kinds.isEmpty()) {
        search(frame, kinds);
      }
    } catch (BadInputException | IllegalArgumentException e) {
      trouble("a picture of " + frame + ": " + e.getMessage());
    }
    remark("SEEN", "last " + seenLast + " objects; " + sought.remark() + "; camera " + lenses);
  }

  private void search(CameraFrame frame, Set<MarineKind> kinds) {
    CameraFrame pixels = unpacked(frame);
    long micros = frame.measuredAtMicros();
    Rotation level = Rotation.nedFromFrd(attitudes.roll(micros), attitudes.pitch(micros), 0.0);
    List<SeenThing> seen = sight.look(pixels, lenses.of(pixels), level, kinds);
    seenLast = seen.size();
    Map<MarineKind, Integer> numbers = messages.numbers();
    for (SeenThing thing : seen) {
      publish(Channels.SENSED_OBJECTS, messages.of(thing, numbers, micros));
    }
  }

  private CameraFrame unpacked(CameraFrame frame) {
    if (frame.format() != CameraFrame.PixelFormat.JPEG) {
      return frame;
    }
    return jpeg.orElseThrow(() -> new BadInputException("no JPEG decoder on the class path"))
        .decode(frame);
  }
}
