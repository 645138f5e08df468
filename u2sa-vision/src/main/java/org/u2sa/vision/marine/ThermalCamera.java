package org.u2sa.vision.marine;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.u2sa.device.CameraSensor;
import org.u2sa.device.MountingPose;
import org.u2sa.device.port.Camera;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.marine.HotTarget;
import org.u2sa.service.ServiceContext;
import org.u2sa.vision.camera.LensChoice;
import org.u2sa.vision.ground.CameraMount;

/**
 * Detects hot targets in the grey pictures of a thermal camera, whose values are temperatures from
 * COLDEST to HOTTEST, while a current goal needs them (thesis 4.2.1.2). In: goals. Out:
 * sensed-objects in BODY: HotTarget with the time of the image and the excess temperature.
 */
public final class ThermalCamera extends CameraSensor {
  private final ThermalVariables variables = settings(ThermalVariables.class).get();
  private final SoughtKinds sought = sought();
  private final LensChoice lenses = new LensChoice(Optional.empty(), variables.angleOfView());
  private final ThermalSight sight = new ThermalSight(variables);
  private final MarineMessages messages = messages();
  private int seenLast;

  public ThermalCamera(ServiceContext context) {
    super(context, "ThermalCamera");
  }

  public ThermalCamera(ServiceContext context, Camera camera) {
    super(context, "ThermalCamera", camera);
  }

  private SoughtKinds sought() {
    SoughtKinds kinds = new SoughtKinds("HotTarget", variables.always(), variables.kindsByGoal());
    subscribe(Channels.GOALS, kinds::goals);
    return kinds;
  }

  private MarineMessages messages() {
    CameraMount mount = CameraMount.of(settings(MountingPose.class).get(), 0.0);
    return new MarineMessages(sensorName(), null, mount, variables.angleSigma());
  }

  @Override
  protected void look(CameraFrame frame) {
    if (!sought.next().isEmpty()) {
      Map<MarineKind, Integer> numbers = messages.numbers();
      List<ThermalSight.Warm> found = sight.look(frame, lenses.of(frame));
      seenLast = found.size();
      for (ThermalSight.Warm warm : found) {
        HotTarget target = (HotTarget) messages.of(warm.thing(), numbers, frame.measuredAtMicros());
        target.width(variables.targetWidth()).height(variables.targetHeight());
        publish(Channels.SENSED_OBJECTS, target.excessTemperature(warm.excessK()));
      }
    }
    remark("SEEN", "last " + seenLast + " targets; " + sought.remark());
  }
}
