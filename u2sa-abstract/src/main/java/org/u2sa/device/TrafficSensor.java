package org.u2sa.device;

import java.util.stream.Stream;
import org.u2sa.device.port.TrafficReceiver;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.shape.MovingSphere;
import org.u2sa.service.ServiceContext;

/**
 * Publishes other traffic as moving keep-out spheres, in GLOBAL, once per report (thesis 4.4.1.3).
 * In: state, whose altitude is assumed for targets that do not report theirs. Out: sensed-objects,
 * uid {@code traffic} and the target's id.
 */
public final class TrafficSensor extends DeviceSensor<TrafficReceiver.Traffic> {
  private static final SensorKind<TrafficReceiver> KIND =
      new SensorKind<>(
          "TrafficSensor",
          TrafficReceiver.class,
          new Devices.Usual("traffic receiver", "RECEIVER", "GDL90", "udp:4000"),
          Channels.SENSED_OBJECTS,
          20.0, // Hz
          10.0); // s

  private final TrafficSpheres spheres = new TrafficSpheres(this, new OwnAltitude(this)::metres);

  public TrafficSensor(ServiceContext context) {
    super(context, KIND);
  }

  public TrafficSensor(ServiceContext context, TrafficReceiver receiver) {
    super(context, KIND, receiver);
  }

  @Override
  protected Stream<MovingSphere> messages(TrafficReceiver.Traffic traffic) {
    return spheres.of(traffic);
  }
}
