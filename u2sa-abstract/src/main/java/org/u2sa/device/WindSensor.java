package org.u2sa.device;

import java.util.stream.Stream;
import org.u2sa.device.port.Anemometer;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.service.ServiceContext;

/**
 * Publishes the vehicle's horizontal velocity through the air from the apparent wind, in BODY, once
 * per reading (thesis 4.2.1.1). Out: sensed-state.
 */
public final class WindSensor extends DeviceSensor<Anemometer.Wind> {
  private static final SensorKind<Anemometer> KIND =
      new SensorKind<>(
          "WindSensor",
          Anemometer.class,
          new Devices.Usual("anemometer", "ANEMOMETER", "NMEA", "serial:/dev/ttyUSB0?baud=4800"),
          Channels.SENSED_STATE,
          20.0, // Hz
          3.0); // s

  private record Variables(
      @Variable(unit = "rad", min = -Math.PI, max = Math.PI, ifAbsent = 0)
          @Description("Direction of the instrument's zero, from straight ahead to the left.")
          double mountedYaw,
      @Variable(unit = "m/s", min = 0.001, max = 20, ifAbsent = 0.3)
          @Description("Standard deviation of the wind speed, from the data sheet.")
          double speedSigma,
      @Variable(unit = "rad", min = 0.0001, max = 1, ifAbsent = 0.035)
          @Description("Standard deviation of the wind direction, from the data sheet.")
          double directionSigma) {}

  private final Settings<Variables> tuning = settings(Variables.class);

  public WindSensor(ServiceContext context) {
    super(context, KIND);
  }

  public WindSensor(ServiceContext context, Anemometer anemometer) {
    super(context, KIND, anemometer);
  }

  @Override
  protected Stream<StateInformation> messages(Anemometer.Wind wind) {
    Variables now = tuning.get();
    double cos = Math.cos(wind.fromRad() + now.mountedYaw());
    double sin = Math.sin(wind.fromRad() + now.mountedYaw());
    double acrossMps = now.directionSigma() * wind.speedMps();
    return Stream.of( // the vehicle moves through the air toward where the wind comes from
        new StateInformation()
            .sensorName(sensorName())
            .referenceFrame(ReferenceFrame.BODY)
            .fluidxDot(wind.speedMps() * cos)
            .fluidyDot(wind.speedMps() * sin)
            .fluidxDotSigma(Math.hypot(now.speedSigma() * cos, acrossMps * sin))
            .fluidyDotSigma(Math.hypot(now.speedSigma() * sin, acrossMps * cos)));
  }
}
