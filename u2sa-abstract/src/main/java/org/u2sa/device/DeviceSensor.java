package org.u2sa.device;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.u2sa.device.port.Device;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.Sensor;
import org.u2sa.service.ServiceContext;

/**
 * The service of every sensor with a device (thesis 3.2.2.2): opens the configured device, reads it
 * at RATE, reports loss, silence and malformed data in log and health, publishes the messages of
 * each new reading, and closes the device. A subclass adds its {@link SensorKind}, variables, the
 * mapping from reading to {@link #messages}, and two constructors: one for launchers, and one with
 * a given device, e.g. a simulated one.
 *
 * @param <R> readings of the device
 */
public abstract class DeviceSensor<R extends Device.Reading> extends Sensor {
  private static final Range TIMEOUT_S = Range.of(0.05, 600.0);

  private final Channel<?> channel;
  private final Device<R> device;
  private final DeviceReader<R> reader;

  /**
   * @throws org.u2sa.interfaces.BadInputException if there is no such driver
   */
  protected <D extends Device<R>> DeviceSensor(ServiceContext context, SensorKind<D> kind) {
    this(context, kind, Optional.empty());
  }

  /** Uses the given device, e.g. a simulated one; it is closed with the service. */
  protected <D extends Device<R>> DeviceSensor(
      ServiceContext context, SensorKind<D> kind, D device) {
    this(context, kind, Optional.of(device));
  }

  <D extends Device<R>> DeviceSensor(ServiceContext context, SensorKind<D> kind, Optional<D> made) {
    super(context, kind.role(), kind.serviceName(), kind.rateHz());
    channel = kind.channel();
    registerPublisher(channel);
    String name = "the " + kind.usual().noun();
    double silentAfterS =
        getVariable(
            VariableDeclaration.number("TIMEOUT", "s")
                .range(TIMEOUT_S)
                .ifAbsent(kind.silentAfterS())
                .describedAs(
                    "Time without a new reading after which " + name + " counts as silent."));
    device = Devices.open(kind.port(), kind.usual(), context, getServiceName(), made);
    reader = new DeviceReader<>(this, name, device, silentAfterS);
  }

  /**
   * Maps a new reading to the messages to publish, in order; messages without a timestamp get the
   * reading's timestamp.
   *
   * @throws IllegalArgumentException if a message rejects a value: the reading is then dropped,
   *     counted and reported as malformed data
   */
  protected abstract Stream<? extends U2SAData> messages(R reading);

  final Device<R> device() {
    return device;
  }

  @Override
  protected final void step(double nowS) {
    reader.next(clock().micros()).ifPresent(this::use);
  }

  void use(R reading) {
    reader
        .mapped(() -> stamped(reading))
        .ifPresent(messages -> messages.forEach(message -> publish(channel, message)));
  }

  private List<U2SAData> stamped(R reading) {
    return messages(reading)
        .map(
            message -> {
              if (message.timestamp().isEmpty()) {
                message.timestamp(reading.measuredAtMicros());
              }
              return message;
            })
        .collect(Collectors.toList());
  }

  @Override
  protected final void release() {
    device.close();
  }
}
