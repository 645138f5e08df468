package org.u2sa.device;

import java.util.stream.Stream;
import org.u2sa.device.mapping.FixMapping;
import org.u2sa.device.port.GpsFix;
import org.u2sa.device.port.GpsReceiver;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.StateInformation;
import org.u2sa.service.ServiceContext;

/**
 * Publishes position and velocity over ground of a GNSS receiver, in GLOBAL, once per fix (thesis
 * 4.6.3). Out: sensed-state, only for new fixes.
 */
public final class GpsSensor extends DeviceSensor<GpsFix> {
  private static final SensorKind<GpsReceiver> KIND =
      new SensorKind<>(
          "GpsSensor",
          GpsReceiver.class,
          new Devices.Usual("GPS receiver", "RECEIVER", "NMEA", "serial:/dev/ttyUSB0?baud=9600"),
          Channels.SENSED_STATE,
          50.0, // Hz
          2.5); // s

  private record Variables(
      @Variable(unit = "s", min = 0, max = 5, ifAbsent = 0)
          @Description(
              "Latency from measurement to arrival of a fix, from the data sheet; states are timestamped with the time of measurement.")
          double delay) {}

  private final FixMapping fixes =
      new FixMapping(this, sensorName(), settings(Variables.class).get().delay());

  public GpsSensor(ServiceContext context) {
    super(context, KIND);
  }

  public GpsSensor(ServiceContext context, GpsReceiver receiver) {
    super(context, KIND, receiver);
  }

  @Override
  protected Stream<StateInformation> messages(GpsFix fix) {
    return fixes.state(fix).stream();
  }
}
