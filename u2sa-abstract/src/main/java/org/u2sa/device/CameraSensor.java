package org.u2sa.device;

import java.util.Optional;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.service.ExteroceptiveSensor;
import org.u2sa.service.ServiceContext;

/**
 * A service that looks through a camera (thesis 3.2.2.3, 4.1.2): its author writes {@link #look}
 * and publishes what it finds. Out: sensed-objects; pixels only compressed, on images, for people
 * to look at.
 *
 * <p>A class of a system file has a public constructor (ServiceContext) for the camera that its
 * configuration names. With a further one (ServiceContext, Camera) the Android application passes
 * it the phone's camera.
 */
public abstract class CameraSensor extends ExteroceptiveSensor {
  private static final double STEPS_PER_S = 30.0;

  private static final Devices.Usual USUAL =
      new Devices.Usual("camera", "CAMERA", "MJPEG", "tcp:192.168.0.20:8080");

  private record Tuning(
      @Variable(
              unit = "s",
              min = 0.1,
              max = 60,
              ifAbsent = 2,
              text = "Time without a picture after which the camera counts as silent.")
          double timeout) {}

  private final Camera camera;
  private final DeviceReader<CameraFrame> reader;

  /** With the camera that the configuration names. */
  protected CameraSensor(ServiceContext context, String serviceName) {
    this(context, serviceName, Optional.empty());
  }

  /** With a camera that the host made: the phone's, a simulated one. Closed with the service. */
  protected CameraSensor(ServiceContext context, String serviceName, Camera camera) {
    this(context, serviceName, Optional.of(camera));
  }

  /**
   * The camera that a configuration names, opened without a service, for a command; the caller
   * closes it.
   *
   * @throws org.u2sa.interfaces.BadInputException if no driver has the name
   */
  public static Camera open(ServiceContext context) {
    return Devices.open(Camera.class, USUAL, context, Optional.empty());
  }

  private CameraSensor(ServiceContext context, String serviceName, Optional<Camera> made) {
    super(context, serviceName, STEPS_PER_S);
    double silentAfterS = settings(Tuning.class).get().timeout();
    camera = Devices.open(Camera.class, USUAL, context, made);
    reader = new DeviceReader<>(this, "the camera", camera, silentAfterS);
  }

  /** Looks at a frame, each at most once and the newest only, on the service's thread. */
  protected abstract void look(CameraFrame frame);

  @Override
  protected final void step(double nowS) {
    reader.next(clock().micros()).ifPresent(this::look);
  }

  @Override
  protected final void release() {
    camera.close();
  }
}
