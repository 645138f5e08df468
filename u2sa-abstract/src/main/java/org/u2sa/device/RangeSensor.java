package org.u2sa.device;

import java.util.Optional;
import org.u2sa.device.port.RangeFinder;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.service.ExteroceptiveSensor;
import org.u2sa.service.ServiceContext;

/**
 * Publishes the nearest object detected by a single-beam range finder, as a point in BODY (thesis
 * 4.1.2). Out: sensed-objects, once per measurement with an object in range.
 */
public final class RangeSensor extends ExteroceptiveSensor {
  private static final double STEPS_PER_S = 50.0;
  private static final double SILENT_AFTER_S = 0.5; // the slowest supported device measures at 7 Hz

  private static final Devices.Usual USUAL =
      new Devices.Usual("range finder", "MODEL", "LV", "serial:/dev/ttyUSB0?baud=9600");

  private final RangeFinder finder;
  private final DeviceReader<RangeFinder.Distance> reader;
  private final MountingPose.Turn mounted;

  /** Launcher constructor: opens the configured range finder. */
  public RangeSensor(ServiceContext context) {
    this(context, Optional.empty());
  }

  /** Uses the given range finder, e.g. a simulated one. */
  public RangeSensor(ServiceContext context, RangeFinder finder) {
    this(context, Optional.of(finder));
  }

  private RangeSensor(ServiceContext context, Optional<RangeFinder> made) {
    super(context, "RangeSensor", STEPS_PER_S);
    mounted = settings(MountingPose.class).get().turn();
    finder = Devices.open(RangeFinder.class, USUAL, context, made);
    reader = new DeviceReader<>(this, "the range finder", finder, SILENT_AFTER_S);
  }

  @Override
  protected void step(double nowS) {
    reader
        .next(clock().micros())
        .filter(distance -> distance.rangeM().isPresent())
        .ifPresent(distance -> publish(Channels.SENSED_OBJECTS, object(distance)));
  }

  private ObjectDescription object(RangeFinder.Distance distance) {
    Point seen = mounted.toBody(Point.of(distance.rangeM().getAsDouble(), 0.0, 0.0));
    ObjectDescription object =
        new ObjectDescription()
            .uid(sensorName())
            .sensorName(sensorName())
            .referenceFrame(ReferenceFrame.BODY)
            .x(seen.x())
            .y(seen.y())
            .z(seen.z());
    object.timestamp(distance.measuredAtMicros());
    return object;
  }

  @Override
  protected void release() {
    finder.close();
  }
}
