package org.u2sa.device;

import java.util.stream.Stream;
import org.u2sa.device.port.RangeFinder;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.service.ServiceContext;

/**
 * Publishes the nearest object detected by a single-beam range finder, as a point in BODY (thesis
 * 4.1.2). Out: sensed-objects, once per measurement with an object in range.
 */
public final class RangeSensor extends DeviceSensor<RangeFinder.Distance> {
  private static final SensorKind<RangeFinder> KIND =
      new SensorKind<>(
          "RangeSensor",
          RangeFinder.class,
          new Devices.Usual("range finder", "MODEL", "LV", "serial:/dev/ttyUSB0?baud=9600"),
          Channels.SENSED_OBJECTS,
          50.0, // Hz
          0.5); // s

  private final MountingPose.Turn mounted = settings(MountingPose.class).get().turn();

  public RangeSensor(ServiceContext context) {
    super(context, KIND);
  }

  public RangeSensor(ServiceContext context, RangeFinder finder) {
    super(context, KIND, finder);
  }

  @Override
  protected Stream<ObjectDescription> messages(RangeFinder.Distance distance) {
    return distance.rangeM().stream().mapToObj(this::object);
  }

  private ObjectDescription object(double rangeM) {
    Point seen = mounted.toBody(Point.of(rangeM, 0.0, 0.0));
    return new ObjectDescription()
        .uid(sensorName())
        .sensorName(sensorName())
        .referenceFrame(ReferenceFrame.BODY)
        .x(seen.x())
        .y(seen.y())
        .z(seen.z());
  }
}
