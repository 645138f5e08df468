package org.u2sa.device;

import java.util.Optional;
import org.u2sa.device.port.Camera;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.service.ExteroceptiveSensor;
import org.u2sa.service.ServiceContext;

/**
 * Base class of camera services (thesis 3.2.2.3, 4.1.2): subclasses implement {@link #look} and
 * publish their detections. Out: sensed-objects; images, compressed and for people only.
 *
 * <p>A class in a system file needs a public constructor (ServiceContext), which uses the
 * configured camera. With another constructor (ServiceContext, Camera) the Android application can
 * pass the phone's camera.
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

  /** Opens the configured camera. */
  protected CameraSensor(ServiceContext context, String serviceName) {
    this(context, serviceName, Optional.empty());
  }

  /** Uses the given camera, e.g. the phone's or a simulated one; it is closed with the service. */
  protected CameraSensor(ServiceContext context, String serviceName, Camera camera) {
    this(context, serviceName, Optional.of(camera));
  }

  /**
   * Opens the configured camera without a service, for commands; the caller closes it.
   *
   * @throws org.u2sa.interfaces.BadInputException if there is no such driver
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

  /** Processes the latest frame, each frame at most once, on the service's thread. */
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
