package org.u2sa.device;

import java.util.Optional;
import org.u2sa.device.port.GpsReceiver;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.service.ProprioceptiveSensor;
import org.u2sa.service.ServiceContext;

/**
 * Publishes position and velocity over ground of a GNSS receiver, in GLOBAL, once per fix (thesis
 * 4.6.3). Out: sensed-state, only for new fixes.
 */
public final class GpsSensor extends ProprioceptiveSensor {
  private static final double STEPS_PER_S = 50.0; // average latency of a fix: 10 ms

  private static final Devices.Usual USUAL =
      new Devices.Usual("receiver", "RECEIVER", "NMEA", "serial:/dev/ttyUSB0?baud=9600");

  private record Tuning(
      @Variable(
              unit = "s",
              min = 0.1,
              max = 60,
              ifAbsent = 2.5,
              text = "Time without a readable message after which the receiver counts as silent.")
          double timeout,
      @Variable(
              unit = "s",
              min = 0,
              max = 5,
              ifAbsent = 0,
              text =
                  "Time from the moment that a fix is of to its arrival, from the data sheet; states get that moment's timestamp.")
          double delay) {}

  private final GpsReceiver receiver;
  private final FixReader reader;

  /** Launcher constructor: opens the configured receiver. */
  public GpsSensor(ServiceContext context) {
    this(context, Optional.empty());
  }

  /** Uses the given receiver, e.g. the phone's or a simulated one. */
  public GpsSensor(ServiceContext context, GpsReceiver receiver) {
    this(context, Optional.of(receiver));
  }

  private GpsSensor(ServiceContext context, Optional<GpsReceiver> made) {
    super(context, "GpsSensor", STEPS_PER_S);
    receiver = Devices.open(GpsReceiver.class, USUAL, context, made);
    Tuning tuning = settings(Tuning.class).get();
    reader = new FixReader(this, receiver, sensorName(), tuning.timeout(), tuning.delay());
  }

  @Override
  protected void step(double nowS) {
    reader.next(clock().micros()).ifPresent(state -> publish(Channels.SENSED_STATE, state));
  }

  @Override
  protected void release() {
    receiver.close();
  }
}
