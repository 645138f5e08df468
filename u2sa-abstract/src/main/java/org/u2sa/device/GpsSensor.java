package org.u2sa.device;

import java.util.Optional;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.service.ProprioceptiveSensor;
import org.u2sa.service.ServiceContext;

/**
 * Publishes where a satellite receiver is and how it moves over ground, in GLOBAL, once for each
 * fix (thesis 4.6.3). Out: sensed-state. Nothing while the receiver has no fix, or nothing new.
 */
public final class GpsSensor extends ProprioceptiveSensor {
  private static final double STEPS_PER_S = 50.0; // a fix waits for its step 10 ms on average

  static final VariableDeclaration<String> CONNECTION =
      VariableDeclaration.text("CONNECTION")
          .ifAbsent("serial:/dev/ttyUSB0?baud=9600")
          .describedAs("Address of the receiver, as its driver takes it (docs/drivers/links.md).");

  static final VariableDeclaration<String> RECEIVER =
      VariableDeclaration.text("RECEIVER")
          .ifAbsent("NMEA")
          .describedAs("Kind of receiver: the name of a driver.");

  static final VariableDeclaration<Double> TIMEOUT =
      VariableDeclaration.number("TIMEOUT", "s")
          .range(Range.of(0.1, 60.0))
          .ifAbsent(2.5)
          .describedAs(
              "Time without a readable message after which the receiver counts as silent.");

  private final GpsReceiver receiver;
  private final FixReader reader;

  /** Called by the launcher: the receiver is the one that the configuration names. */
  public GpsSensor(ServiceContext context) {
    this(context, Optional.empty());
  }

  /** With a receiver that the host made: the phone's, a simulated one. */
  public GpsSensor(ServiceContext context, GpsReceiver receiver) {
    this(context, Optional.of(receiver));
  }

  private GpsSensor(ServiceContext context, Optional<GpsReceiver> made) {
    super(context, "GpsSensor", STEPS_PER_S);
    getVariable(CONNECTION);
    double timeoutS = getVariable(TIMEOUT);
    receiver = Devices.open(GpsReceiver.class, RECEIVER, context, made);
    reader = new FixReader(this, receiver, sensorName(), timeoutS);
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
