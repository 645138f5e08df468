package org.u2sa.device;

import java.util.Optional;
import java.util.stream.Stream;
import org.u2sa.device.port.Camera;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.service.ServiceContext;

/**
 * Base class of camera services (thesis 3.2.2.3, 4.1.2): subclasses implement {@link #look} and
 * publish their detections. Out: sensed-objects; images, compressed, for people only.
 *
 * <p>A class in a system file needs a public constructor (ServiceContext); with another one
 * (ServiceContext, Camera) the Android application can pass the phone's camera.
 */
public abstract class CameraSensor extends DeviceSensor<CameraFrame> {
  private static final Devices.Usual USUAL =
      new Devices.Usual("camera", "CAMERA", "MJPEG", "tcp:192.168.0.20:8080");

  /** Opens the configured camera. */
  protected CameraSensor(ServiceContext context, String serviceName) {
    super(context, kind(serviceName));
  }

  /** Uses the given camera, e.g. a simulated one; it is closed with the service. */
  protected CameraSensor(ServiceContext context, String serviceName, Camera camera) {
    super(context, kind(serviceName), camera);
  }

  /**
   * Opens the configured camera without a service; the caller closes it.
   *
   * @throws org.u2sa.interfaces.BadInputException if there is no such driver
   */
  public static Camera open(ServiceContext context) {
    return Devices.open(Camera.class, USUAL, context, "camera", Optional.empty());
  }

  private static SensorKind<Camera> kind(String serviceName) {
    return new SensorKind<>(
        serviceName,
        Camera.class,
        USUAL,
        Channels.SENSED_OBJECTS,
        30.0, // Hz
        2.0); // s
  }

  /** Processes the latest frame, each at most once, on the service's thread. */
  protected abstract void look(CameraFrame frame);

  @Override
  final void use(CameraFrame frame) {
    look(frame); // exceptions from here are the author's, not the camera's
  }

  /** Empty: {@link #look} publishes. */
  @Override
  protected final Stream<ObjectDescription> messages(CameraFrame frame) {
    return Stream.empty();
  }
}
